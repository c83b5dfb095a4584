// rsh_render_test.cpp - the program as a whole: what it wants to be asked for, and how it ends.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "program.hpp"
#include "temporary_folder.hpp"

namespace render {
namespace {

// Until the process has a handler for the signal.
void wait_until_caught(pid_t process, int signal) {
    for (int i = 0; i < 2000; ++i) {
        std::ifstream status("/proc/" + std::to_string(process) + "/status");
        std::string word;
        while (status >> word && word != "SigCgt:") continue;
        if (status >> word && std::stoull(word, nullptr, 16) >> (signal - 1) & 1) return;
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    ADD_FAILURE() << "no handler for signal " << signal << " after 20 s";
}

class RshRender : public testing::Test {
protected:
    std::string scene() const {
        return folder_.write("scene.json",
                             R"({"meshes": [{"generator": "room", "triangles": 1500}]})") +
               " --size 16x16 --bounces 1 ";
    }
    std::string path(const std::string& name) const { return folder_.path(name); }

    // The run fails with a message that has all of `parts`.
    void expect_error(const std::string& arguments, std::initializer_list<std::string> parts) {
        const Ended ended = run(scene() + arguments);
        EXPECT_NE(ended.status, 0) << arguments;
        for (const std::string& part : parts)
            EXPECT_NE(ended.printed.find(part), std::string::npos)
                << arguments << ": \"" << part << "\" is not in: " << ended.printed;
    }

    TemporaryFolder folder_;
};

TEST_F(RshRender, SaysWhatToAddWhenNothingIsAskedFor) {
    expect_error("", {"--out", "--json", "--stats", "--check"});
    expect_error("--check-rays 5 --no-shadow", {"--out", "--json", "--stats", "--check"});
}

TEST_F(RshRender, IsContentWithAnyOneOutput) {
    for (const std::string& output :
         {"--out " + path("a.png"), "--layers " + path("a.exr"), "--json " + path("a.json"),
          std::string("--stats"), std::string("--check 1"), std::string("--audit 20")}) {
        const Ended ended = run(scene() + output);
        EXPECT_EQ(ended.status, 0) << output << ": " << ended.printed;
    }
    EXPECT_EQ(content(path("a.png")).substr(1, 3), "PNG");
    EXPECT_EQ(content(path("a.json")).substr(0, 1), "{");
}

TEST_F(RshRender, NamesTheToleranceInEveryOutput) {
    const Ended ended = run(scene() + "--tolerance 0.01 --stats --json " + path("a.json") +
                            " --out " + path("a.png"));
    EXPECT_EQ(ended.status, 0) << ended.printed;
    EXPECT_NE(ended.printed.find("approximate: tolerance 0.01\n"), std::string::npos)
        << ended.printed;
    EXPECT_NE(content(path("a.json")).find("\"tolerance\": 0.01,"), std::string::npos);
    EXPECT_EQ(description_of(path("a.png")), "approximate: tolerance 0.01");
}

TEST_F(RshRender, SaysNothingOfAToleranceOfZero) {
    const Ended ended = run(scene() + "--tolerance 0 --stats --out " + path("a.png"));
    EXPECT_EQ(ended.status, 0) << ended.printed;
    EXPECT_EQ(ended.printed.find("approximate"), std::string::npos) << ended.printed;
    EXPECT_EQ(description_of(path("a.png")), "");
}

// Fewer than all of them.
TEST_F(RshRender, AuditsSomeRaysOfEveryFrame) {
    const auto audited = [&](const std::string& options) {
        const Ended ended = run(scene() + options);
        EXPECT_EQ(ended.status, 0) << ended.printed;
        std::vector<int> rays;
        std::istringstream lines(ended.printed);
        for (std::string line; std::getline(lines, line);) {
            int differences = 0, count = 0;
            if (sscanf(line.c_str(), "%d of %d hits differ", &differences, &count) != 2)
                continue;
            EXPECT_EQ(differences, 0);
            rays.push_back(count);
        }
        return rays;
    };
    const std::vector<int> all = audited("--frames 3 --check 3"),
                           some = audited("--frames 3 --audit 20");
    ASSERT_EQ(all.size(), 3u);
    ASSERT_EQ(some.size(), 3u);
    for (size_t frame = 0; frame < 3; ++frame) {
        EXPECT_GE(some[frame], 20);
        EXPECT_LT(some[frame], all[frame]);
    }
}

// No folder of scenes is searched and no device is opened before: the scene need not be there.
TEST_F(RshRender, RefusesNumbersThatDoNotFitTheirOption) {
    for (const std::string wrong :
         {"--min-weight nan", "--min-weight 1.5", "--time nan", "--time inf", "--time -inf",
          "--time 1e999", "--frames 1e9", "--frames -1", "--frames 2.5", "--bounces -1",
          "--bounces 1e99", "--budget -1", "--max-texture-pixels -1",
          "--max-texture-pixels 1e99", "--size 1e99x4", "--size -4x4", "--check-rays 0",
          "--audit 0", "--check -1"}) {
        const Ended ended = run("none.json --stats " + wrong);
        EXPECT_GT(ended.status, 100) << wrong << ": " << ended.printed;
        EXPECT_LT(ended.status, 128) << wrong << ": " << ended.printed;
        EXPECT_NE(ended.printed.find(wrong.substr(0, wrong.find(' '))), std::string::npos)
            << wrong << ": " << ended.printed;
    }
}

TEST_F(RshRender, ChecksItsOutputsFirst) {
    folder_.write("folder/x", "");
    const auto wrong = [&](const std::string& option,
                           std::initializer_list<std::string> parts) {
        const Ended ended = run("none.json " + option);
        EXPECT_EQ(ended.status, 1) << option;
        for (const std::string& part : parts)
            EXPECT_NE(ended.printed.find(part), std::string::npos)
                << option << ": \"" << part << "\" is not in: " << ended.printed;
    };
    wrong("--out ''", {"--out", "no name"});
    wrong("--json ''", {"--json", "no name"});
    wrong("--inspect --json ''", {"--json", "no name"});
    wrong("--out " + path("none/a.png"), {"--out", path("none/a.png"), "folder"});
    wrong("--json " + path("none/a"), {"--json", path("none/a"), "folder"});
    wrong("--out " + path("folder"), {"is a folder"});
    wrong("--out " + path("folder/"), {"is a folder"});
    wrong("--out " + path("folder/x/a.png"), {"folder"});
    for (const char* ending : {"", ".", ".pgn", ".txt", ".png.xz", ".null"})
        wrong("--out " + path(std::string("a") + ending), {"ending", ".png", ".exr"});
    wrong("--size 4x16384 --out " + path("a.webp"), {"4 x 16384", ".webp", "16383"});
    wrong("--layers " + path("a.png"), {"--layers", "\".png\"", ".exr"});
    wrong("--layers " + path("none/a.exr"), {"--layers", path("none/a.exr"), "folder"});
    wrong("--out " + path("a.png") + " --json " + path("a.png"), {"--out", "its own"});
    wrong("--out " + path("a.exr") + " --layers " + path("a.exr"), {"--out", "its own"});
    wrong("--json " + path("a.exr") + " --layers " + path("a.exr"), {"--json", "its own"});
}

TEST_F(RshRender, ChecksTheFoldersOfAllFrames) {
    folder_.write("frame0/x", "");
    expect_error("--frames 2 --out " + path("frame%d/a.png"), {path("frame1"), "folder"});
    EXPECT_EQ(content(path("frame0/a.png")), "") << "was written before the check";
    folder_.write("frame1/x", "");
    EXPECT_EQ(run(scene() + "--frames 2 --out " + path("frame%d/a.png")).status, 0);
    EXPECT_NE(content(path("frame1/a.png")), "");
}

TEST_F(RshRender, FailsWhenAnOutputCannotBeWritten) {
    expect_error("--json /dev/full", {"/dev/full", "No space"});
    expect_error("--stats >/dev/full", {});
    folder_.write("a.png", "old");
    std::filesystem::create_symlink("/dev/full", path("full.png"));
    expect_error("--out " + path("full.png"), {"full.png", "No space"});
}

// Nobody may write to /proc, not even root.
TEST_F(RshRender, SaysThatPoclNeedsAFolderForItsCache) {
    for (const std::string variable : {"HOME", "XDG_CACHE_HOME", "POCL_CACHE_DIR"}) {
        const std::string environment =
            "env -u XDG_CACHE_HOME -u POCL_CACHE_DIR " + variable + "=/proc/none ";
        if (run("--list-devices", environment).status == 0)
            GTEST_SKIP() << "there is a device other than PoCL's";
        for (const std::string& arguments :
             {std::string("--list-devices"), scene() + "--stats"}) {
            const Ended ended = run(arguments, environment);
            EXPECT_EQ(ended.status, 1) << environment << arguments;
            for (const char* part :
                 {"no OpenCL device", "PoCL", variable.c_str(), "/proc/none"})
                EXPECT_NE(ended.printed.find(part), std::string::npos)
                    << environment << arguments << ": " << ended.printed;
        }
    }
}

// On a device that says that it is a GPU: tests/support/layers/gpu.cpp.
TEST_F(RshRender, DrawsTheSamePictureByTheEngineThatSuitsTheDevice) {
    const auto picture_of = [&](const std::string& options, const std::string& environment,
                                const std::string& engine) {
        const Ended ended =
            run(scene() + options + " --json " + path("a.json") + " --out " + path("a.png"),
                environment);
        EXPECT_EQ(ended.status, 0) << options << ": " << ended.printed;
        const std::string json = content(path("a.json"));
        EXPECT_NE(json.find("\"engine\": \"" + engine + "\""), std::string::npos)
            << options << ": " << json;
        return content(path("a.png"));
    };
    const std::string gpu = "env OPENCL_LAYERS='" RSH_GPU_LAYER "'";
    const std::string expected = picture_of("--engine tiles", "", "tiles");
    for (const char* options : {"", "--engine auto"})
        EXPECT_EQ(picture_of(options, gpu, "paper_faithful"), expected) << options;
    EXPECT_EQ(picture_of("--engine tiles", gpu, "tiles"), expected);
}

// As tests/support/layers/counts.cpp counts.
TEST_F(RshRender, ReleasesAllThatItMade) {
    const Ended ended = run(
        scene() + " --out " + path("a.png"),
        "env OPENCL_LAYERS='" RSH_COUNTS_LAYER "' RSH_COUNTS='" + path("counts.json") + "'");
    EXPECT_EQ(ended.status, 0) << ended.printed;
    const std::string counts = content(path("counts.json"));
    EXPECT_EQ(counts.find("\"launches\": 0,"), std::string::npos) << counts;
    for (const char* objects : {"bytes", "buffers", "sub_buffers", "programs", "kernels",
                                "contexts", "queues", "events"})
        EXPECT_NE(counts.find("\"" + std::string(objects) + "_alive\": 0"), std::string::npos)
            << objects << " are left: " << counts;
}

TEST_F(RshRender, EndsBySignalsWhileItMeasuresAndChecks) {
    const std::string file =
        folder_.write("big.json", R"({"meshes": [{"generator": "room", "triangles": 20000}]})");
    for (const char* output : {"--stats", "--check=10000"}) {
        const pid_t child = fork();
        if (child == 0) {
            std::signal(SIGTERM, SIG_DFL);  // a shell's background job ignores SIGINT
            execl(RSH_RENDER, RSH_RENDER, file.c_str(), "--size", "256x256", "--frames",
                  "10000", output, static_cast<char*>(nullptr));
            _exit(127);
        }
        wait_until_caught(child, SIGTERM);
        std::this_thread::sleep_for(std::chrono::seconds(1));  // until it renders, or nearly
        kill(child, SIGTERM);
        int status = 0;
        waitpid(child, &status, 0);
        ASSERT_TRUE(WIFEXITED(status)) << output << " ended by signal " << WTERMSIG(status);
        EXPECT_EQ(WEXITSTATUS(status), 128 + SIGTERM) << output;
    }
}

TEST_F(RshRender, EndsBySignalsWithTheOldPicture) {
    const std::string picture = folder_.write("a.png", "old");
    const std::string file =
        folder_.write("big.json", R"({"meshes": [{"generator": "room", "triangles": 1500}]})");
    for (const int signal : {SIGTERM, SIGINT}) {
        const pid_t child = fork();
        if (child == 0) {
            std::signal(signal, SIG_DFL);  // a shell's background job ignores SIGINT
            execl(RSH_RENDER, RSH_RENDER, file.c_str(), "--size", "512x512", "--frames", "1000",
                  "--out", picture.c_str(), static_cast<char*>(nullptr));
            _exit(127);
        }
        wait_until_caught(child, signal);
        kill(child, signal);
        int status = 0;
        waitpid(child, &status, 0);
        ASSERT_TRUE(WIFEXITED(status)) << "ended by signal " << WTERMSIG(status);
        EXPECT_EQ(WEXITSTATUS(status), 128 + signal);
        EXPECT_EQ(content(picture), "old");
    }
}

}  // namespace
}  // namespace render
