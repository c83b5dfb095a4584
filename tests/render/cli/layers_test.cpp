// layers_test.cpp - every pixel of --layers against the scene's definition, in double.
#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <glm/glm.hpp>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "program.hpp"
#include "temporary_folder.hpp"

namespace render {
namespace {

constexpr uint32_t kWidth = 149, kHeight = 141;  // three strips
constexpr double kShift = 0.25;                  // of the first mesh, from frame to frame

struct Triangle {
    std::array<glm::dvec3, 3> corners, normals;  // normals 0: flat
    uint32_t material;
};

// A wall of two triangles with tilted normals, one triangle that shows its back, one that the wall
// hides in part.
const std::vector<Triangle> kScene{
    {{{{-2, -1, 0}, {0.5, -1, 0}, {0.5, 1, 0}}}, {{{-1, 0, 1}, {0, 0, 1}, {0, 1, 1}}}, 0},
    {{{{-2, -1, 0}, {0.5, 1, 0}, {-2, 1, 0}}}, {{{-1, 0, 1}, {0, 1, 1}, {0, 0, -1}}}, 0},
    {{{{0.5, -1.5, 1}, {0.7, 1, 0.5}, {1.5, -0.5, 0}}}, {}, 1},
    {{{{-0.5, 0.5, -1}, {1.9, 0.8, -1.5}, {0.2, 2, -1}}}, {}, 2},
};

std::string numbers(const char* word, glm::dvec3 v) {
    return std::string(word) + ' ' + std::to_string(v.x) + ' ' + std::to_string(v.y) + ' ' +
           std::to_string(v.z) + '\n';
}

// The triangles of a material as a file of their own.
std::string obj_of(uint32_t material) {
    std::string text;
    int count = 0;
    for (const Triangle& triangle : kScene) {
        if (triangle.material != material) continue;
        for (const glm::dvec3& corner : triangle.corners) text += numbers("v", corner);
        for (const glm::dvec3& normal : triangle.normals)
            text += numbers("vn", glm::length(normal) > 0 ? glm::normalize(normal) : normal);
        text += "f";
        for (int corner = 0; corner < 3; ++corner) {
            const std::string number = std::to_string(++count);
            text += ' ' + number + (material == 0 ? "//" + number : "");
        }
        text += '\n';
    }
    return text;
}

struct Pixel {
    float depth = std::numeric_limits<float>::infinity();
    std::array<float, 3> normal{}, position{};
    uint32_t primitive = 0xffffffffu, material = 0xffffffffu;
    uint32_t tests = 0;
};

glm::dvec3 direction_of(uint32_t x, uint32_t y) {
    const double half = std::tan(glm::radians(22.5)), aspect = double(kWidth) / kHeight;
    return glm::normalize(glm::dvec3(half * aspect * ((x + 0.5) / kWidth * 2 - 1),
                                     half * (1 - (y + 0.5) / kHeight * 2), -1));
}

struct Found {
    Pixel pixel;
    double distance = std::numeric_limits<double>::infinity();
    bool is_near_an_edge = false;  // floats may decide otherwise
};

void meet(glm::dvec3 eye, glm::dvec3 direction, uint32_t index, double shift, Found& found) {
    const Triangle& triangle = kScene[index];
    auto corners = triangle.corners;
    if (triangle.material == 0)
        for (glm::dvec3& corner : corners) corner.x += shift;
    const glm::dvec3 a = corners[1] - corners[0], b = corners[2] - corners[0];
    const glm::dvec3 across = glm::cross(a, b), from = eye - corners[0];
    const double t = -glm::dot(from, across) / glm::dot(direction, across);
    const glm::dvec3 inner = from + t * direction;  // = u a + v b
    const double u = glm::dot(glm::cross(inner, b), across) / glm::dot(across, across),
                 v = glm::dot(glm::cross(a, inner), across) / glm::dot(across, across);
    const std::array<double, 3> weights{1 - u - v, u, v};
    const double inside = *std::min_element(weights.begin(), weights.end());
    if (std::abs(inside) < 1e-4) found.is_near_an_edge = true;
    if (inside < 0 || t > found.distance) return;
    found.distance = t;
    glm::dvec3 flat = glm::normalize(across);
    if (glm::dot(flat, direction) > 0) flat = -flat;
    glm::dvec3 normal(0);
    for (int i = 0; i < 3; ++i)
        if (glm::length(triangle.normals[i]) > 0)
            normal += weights[i] * glm::normalize(triangle.normals[i]);
    normal = glm::length(normal) > 0 ? glm::normalize(normal) : flat;
    if (glm::dot(normal, flat) < 0) normal = -normal;
    const glm::dvec3 point = eye + t * direction;
    found.pixel = {static_cast<float>(t), {}, {}, index, triangle.material};
    for (int i = 0; i < 3; ++i) {
        found.pixel.normal[i] = static_cast<float>(normal[i]);
        found.pixel.position[i] = static_cast<float>(point[i]);
    }
}

Found expected(uint32_t x, uint32_t y, double shift) {
    const glm::dvec3 eye(0, 0, 5);
    Found found;
    for (uint32_t i = 0; i < kScene.size(); ++i) meet(eye, direction_of(x, y), i, shift, found);
    return found;
}

// The channels of a file by their names, each of 4 bytes.
class Layers {
public:
    explicit Layers(const std::string& path) {
        const auto input = OIIO::ImageInput::open(path);
        if (!input) throw std::runtime_error(path + ": " + OIIO::geterror());
        spec_ = input->spec();
        bytes_.resize(spec_.image_bytes(/*native=*/true));
        input->read_image(0, 0, 0, spec_.nchannels, OIIO::TypeDesc::UNKNOWN, bytes_.data());
    }
    const OIIO::ImageSpec& spec() const { return spec_; }
    Pixel at(uint32_t x, uint32_t y) const {
        const size_t i = size_t{y} * kWidth + x;
        Pixel pixel;
        pixel.depth = channel<float>(i, "Z", OIIO::TypeDesc::FLOAT);
        for (int c = 0; c < 3; ++c) {
            const std::string axis = std::string(".") + "XYZ"[c];
            pixel.normal[c] = channel<float>(i, "N" + axis, OIIO::TypeDesc::FLOAT);
            pixel.position[c] = channel<float>(i, "P" + axis, OIIO::TypeDesc::FLOAT);
        }
        pixel.primitive = channel<uint32_t>(i, "primitive", OIIO::TypeDesc::UINT32);
        pixel.material = channel<uint32_t>(i, "material", OIIO::TypeDesc::UINT32);
        pixel.tests = channel<uint32_t>(i, "tests", OIIO::TypeDesc::UINT32);
        return pixel;
    }

private:
    template <typename T>
    T channel(size_t pixel, const std::string& name, OIIO::TypeDesc type) const {
        const int index = spec_.channelindex(name);
        if (index < 0 || spec_.channelformat(index) != type)
            throw std::runtime_error(name + ": is not there, or of another type");
        T value;
        std::memcpy(&value,
                    &bytes_[4 * (pixel * static_cast<size_t>(spec_.nchannels) +
                                 static_cast<size_t>(index))],
                    4);
        return value;
    }

    OIIO::ImageSpec spec_;
    std::vector<char> bytes_;
};

void expect_near(const std::array<float, 3>& found, const std::array<float, 3>& right) {
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(found[i], right[i], 1e-5) << "xyz"[i];
}

// Returns how many pixels see each triangle; the last: none.
std::vector<int> expect_right_pixels(const Layers& layers, double shift) {
    std::vector<int> seen(kScene.size() + 1, 0);
    for (uint32_t y = 0; y < kHeight; ++y)
        for (uint32_t x = 0; x < kWidth; ++x) {
            const Found right = expected(x, y, shift);
            if (right.is_near_an_edge) continue;
            const Pixel found = layers.at(x, y);
            SCOPED_TRACE("pixel " + std::to_string(x) + ", " + std::to_string(y));
            EXPECT_EQ(found.primitive, right.pixel.primitive);
            EXPECT_EQ(found.material, right.pixel.material);
            if (found.primitive != 0xffffffffu) {
                EXPECT_GE(found.tests, 17u) << "a node's boxes and a triangle";
            }
            EXPECT_LT(found.tests, 1000u);
            if (std::isfinite(right.distance))
                EXPECT_NEAR(found.depth, right.pixel.depth, 1e-5);
            else
                EXPECT_EQ(found.depth, right.pixel.depth);
            expect_near(found.normal, right.pixel.normal);
            expect_near(found.position, right.pixel.position);
            ++seen[std::min<size_t>(right.pixel.primitive, kScene.size())];
        }
    return seen;
}

TEST(Layers, SayWhatEveryPixelSees) {
    const TemporaryFolder folder;
    std::string meshes;
    for (uint32_t material = 0; material < 3; ++material) {
        const std::string file =
            folder.write("mesh" + std::to_string(material) + ".obj", obj_of(material));
        meshes += (material ? R"(, {"file": ")" : R"({"file": ")") + file + '"';
        if (material == 0)
            meshes += R"(, "keys": [{"time": 0}, {"time": 1, "translate": [)" +
                      std::to_string(kShift) + ", 0, 0]}]";
        meshes += '}';
    }
    const std::string scene = folder.write(
        "scene.json",
        R"({"camera": {"eye": [0, 0, 5], "at": [0, 0, 0]}, "meshes": [)" + meshes + "]}");
    const Ended ended = run(scene + " --frames 2 --size " + std::to_string(kWidth) + 'x' +
                            std::to_string(kHeight) + " --layers " + folder.path("%d.exr"));
    ASSERT_EQ(ended.status, 0) << ended.printed;
    for (const int frame : {0, 1}) {
        SCOPED_TRACE("frame " + std::to_string(frame));
        const Layers layers(folder.path(std::to_string(frame) + ".exr"));
        ASSERT_EQ(layers.spec().width, static_cast<int>(kWidth));
        ASSERT_EQ(layers.spec().height, static_cast<int>(kHeight));
        for (const int count : expect_right_pixels(layers, frame * kShift))
            EXPECT_GT(count, 50) << "pixels that see a triangle, or none";
    }
}

}  // namespace
}  // namespace render
