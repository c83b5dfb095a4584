#include "table/report.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

namespace bench {
namespace {

// A folder of files, removed at the end.
class Table : public testing::Test {
protected:
    Table() {
        std::string name = testing::TempDir() + "rsh-table.XXXXXX";
        folder_ = ::mkdtemp(name.data());
    }
    ~Table() override { std::filesystem::remove_all(folder_); }

    std::string file(const std::string& name, const std::string& text) {
        const std::filesystem::path path = folder_ / name;
        std::ofstream(path) << text;
        return path.string();
    }
    std::string missing() const { return (folder_ / "missing.json").string(); }

private:
    std::filesystem::path folder_;
};

const std::string kHead =
    R"("device": {"name": "Chip", "driver": "9.1", "platform": "Loom", "compute_units": 7,
                  "memory_bytes": 2147483648, "host_threads": 8, "host_instruction_set": "avx2"},
       "rsh": {"version": "0.1.0", "commit": "abc"}, )";

std::string reduce_case(const std::string& strategy, const std::string& metrics,
                        bool is_ok = true) {
    return R"({"name": "reduce/)" + strategy + R"(", "ok": )" + (is_ok ? "true" : "false") +
           R"(, "params": {"strategy": ")" + strategy +
           R"(", "n": 1048576, "bytes": 4, "keep": 50, "pattern": "random",
               "keep_by": "not_null"}, "metrics": )" +
           metrics + "}";
}

std::string of_suite(const std::string& suite, const std::string& cases,
                     const std::string& more = "") {
    return "{" + kHead + R"("suite": ")" + suite + R"(", "cases": [)" + cases + "]" + more +
           "}";
}

std::string frame_case(const std::string& metrics, bool is_ok = true) {
    return R"({"name": "frame/scene:room/x", "ok": )" + std::string(is_ok ? "true" : "false") +
           R"(, "params": {"scene": "room", "triangles": 20000, "width": 64, "height": 32,
               "rays": "reflection", "active_rays": 2000, "engine": "tiles", "bound": "box",
               "refit": false}, "metrics": )" +
           metrics + "}";
}

// The words of the first line that begins with `start`.
std::vector<std::string> words_of(const std::string& text, const std::string& start) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        if (line.rfind(start, 0) != 0) continue;
        std::istringstream words(line.substr(start.size()));
        return {std::istream_iterator<std::string>(words), {}};
    }
    ADD_FAILURE() << "no line begins with \"" << start << "\" in\n" << text;
    return {};
}

using Words = std::vector<std::string>;

TEST_F(Table, PutsStrategiesAndPeersOfSeveralFilesIntoOneRow) {
    const Report report = make_report(
        {file("a.json", of_suite("reduce", reduce_case("auto", R"({"ratio_to_copy": 0.5,
                                                                   "copy_ms": 0.125})"))),
         file("b.json",
              of_suite("reduce", reduce_case("peer:cub", R"({"ratio_to_copy": 0.75})"))),
         file("c.json", of_suite("reduce", reduce_case("count", "{}")))});
    EXPECT_TRUE(report.is_good);
    // 2 * 4 MiB in an eighth of a millisecond.
    EXPECT_EQ(words_of(report.text, "2^20 x 4 B, 50 %"), (Words{"67.1", "0.50", "0.75", "-"}))
        << report.text;
}

TEST_F(Table, ShowsTheDeviceOnceWhereAllFilesTellTheSame) {
    const std::string text = of_suite("reduce", reduce_case("auto", "{}"));
    const Report report = make_report({file("a.json", text), file("b.json", text)});
    EXPECT_EQ(words_of(report.text, "device: Chip,"),
              (Words{"7", "compute", "units,", "2.0", "GiB"}));
    EXPECT_EQ(words_of(report.text, "host:"), (Words{"avx2,", "8", "threads"}));
    EXPECT_EQ(report.text.find("device:"), report.text.rfind("device:"));
    EXPECT_NE(report.text.find("rsh 0.1.0, commit abc\n"), std::string::npos);
}

TEST_F(Table, NamesAWrongCaseAndIsNotGood) {
    const Report report = make_report(
        {file("a.json", of_suite("reduce", reduce_case("scan", "null", /*is_ok=*/false)))});
    EXPECT_FALSE(report.is_good);
    EXPECT_NE(report.text.find("WRONG: reduce/scan\n"), std::string::npos) << report.text;
    EXPECT_EQ(words_of(report.text, "2^20 x 4 B, 50 %"), (Words{"-", "WRONG"}));
}

TEST_F(Table, TellsWhatWasLeftOutAndWhyAndIsStillGood) {
    const Report report = make_report({file(
        "a.json", of_suite("reduce", reduce_case("auto", "{}"),
                           R"(, "left_out": [{"name": "reduce/big", "why": "no room"}])"))});
    EXPECT_TRUE(report.is_good);
    EXPECT_NE(report.text.find("LEFT OUT\nreduce/big: no room\n"), std::string::npos)
        << report.text;
}

TEST_F(Table, NamesMissingAndHalfWrittenFilesAndStillShowsTheOthers) {
    const std::string good = of_suite("reduce", reduce_case("auto", "{}"));
    const std::string half = file("half.json", good.substr(0, good.size() / 2));
    const std::string other = file("other.json", R"({"answer": 42})");
    const std::string empty = file("empty.json", of_suite("frame", ""));
    const std::string no_name = file("no_name.json", of_suite("reduce", R"({"ok": true})"));
    const Report report =
        make_report({missing(), half, other, empty, no_name, file("good.json", good)});
    EXPECT_FALSE(report.is_good);
    for (const std::string& path : {missing(), half, other, empty, no_name})
        EXPECT_NE(report.text.find("NOT READ: " + path), std::string::npos) << report.text;
    words_of(report.text, "2^20 x 4 B, 50 %");
}

TEST_F(Table, ShowsTheStagesOfAFrameAndADashForAnAbsentMetric) {
    const Report report = make_report({file(
        "a.json",
        of_suite("frame", frame_case(R"({"ms_build": 1.5, "ms_traverse": 2.25, "ms_total": 4,
                                         "tests_per_ray": 30.25, "mismatches": 0})")))});
    EXPECT_TRUE(report.is_good);
    EXPECT_EQ(words_of(report.text, "room 64x32 reflection: "),
              (Words{"20000", "triangles,", "2000", "rays"}));
    EXPECT_EQ(words_of(report.text, "  tiles/box"),
              (Words{"-", "1.50", "2.25", "4.00", "0.5", "30.2", "0"}));
}

std::string stability_case(const std::string& engine, int missed) {
    return R"({"name": "stability/caps/)" + engine + R"(", "ok": )" +
           (missed ? "false" : "true") + R"(, "params": {"family": "caps", "engine": ")" +
           engine + R"("}, "metrics": {"decisions": 500, "undecided": 4, "missed": )" +
           std::to_string(missed) + R"(, "t_error_of_budget": 0.25, "why": "ray 3 misses"}})";
}

TEST_F(Table, ShowsTheWorstCaseOfAFamily) {
    const Report report = make_report(
        {file("a.json", of_suite("stability",
                                 stability_case("tiles", 0) + "," + stability_case("paper", 7) +
                                     "," + R"({"name": "stability/half", "ok": true})"))});
    EXPECT_FALSE(report.is_good);
    EXPECT_EQ(words_of(report.text, "caps"),
              (Words{"1", "500", "4", "7", "0", "0", "0", "0", "0", "0.25"}))
        << report.text;
    EXPECT_NE(report.text.find("WRONG: stability/caps/paper: ray 3 misses\n"),
              std::string::npos);
}

TEST_F(Table, ShowsTimeAndErrorsOfTheContendersOfAScene) {
    const auto hits_case = [](const std::string& contender, const std::string& metrics) {
        return R"({"name": "hits/needles/)" + contender + R"(", "ok": true, "params":
            {"scene": "needles", "group": "thin", "triangles": 20000, "contender": ")" +
               contender + R"("}, "metrics": {"rays": 900, "judged": 100, "missed": )" +
               metrics + "}}";
    };
    const Report report = make_report(
        {file("a.json", of_suite("hits", hits_case("tiles/box", R"(0, "ms_total": 4, "leaks": 0,
                                                   "ratio_embree_robust": 1.5)") +
                                             "," + hits_case("embree/default", "12")))});
    EXPECT_TRUE(report.is_good);
    EXPECT_EQ(words_of(report.text, "needles (thin): "),
              (Words{"20000", "triangles,", "900", "rays,", "100", "judged"}));
    EXPECT_EQ(words_of(report.text, "  tiles/box"),
              (Words{"4.00", "-", "1.50", "0", "-", "-", "-", "0"}));
    EXPECT_EQ(words_of(report.text, "  embree/default"),
              (Words{"-", "-", "-", "12", "-", "-", "-", "-"}));
}

TEST_F(Table, ShowsEachKernelOfAProgram) {
    const Report report =
        make_report({file("a.json", of_suite("programs",
                                             R"({"name": "programs/shade", "ok": true,
                     "params": {"program": "shade", "options": "-D RSH_LIGHTS=2"},
                     "metrics": {"seconds": 0.25, "kernels": [
                         {"name": "rsh_shade", "registers": 40, "spill_bytes": 16,
                          "private_bytes": 8}]}})"))});
    EXPECT_EQ(words_of(report.text, "shade LIGHTS=2:"), (Words{"0.25", "s"}));
    EXPECT_EQ(words_of(report.text, "  rsh_shade"),
              (Words{"40", "16", "-", "-", "8", "-", "-"}));
}

std::string program_case(const std::string& options, const std::string& registers) {
    return R"({"name": "programs/shade )" + options + R"(", "ok": true,
               "params": {"program": "shade", "options": ")" +
           options + R"("},
               "metrics": {"seconds": 1, "kernels": [
                   {"name": "rsh_shade", "registers": )" +
           registers + "}]}}";
}

TEST_F(Table, ShowsAKernelAgainOnlyWhereItsFiguresDiffer) {
    const Report report = make_report(
        {file("a.json", of_suite("programs", program_case("-D A=1", "40") + "," +
                                                 program_case("-D A=2", "40") + "," +
                                                 program_case("-D A=3", "48")))});
    EXPECT_EQ(words_of(report.text, "shade A=2: "),
              (Words{"1.00", "s,", "1", "kernels", "as", "above"}));
    EXPECT_EQ(words_of(report.text, "shade A=3: "), (Words{"1.00", "s"}));
    EXPECT_NE(report.text.find("  rsh_shade    "), report.text.rfind("  rsh_shade    "));
}

TEST_F(Table, SaysWhyAProgramIsWrong) {
    const Report report = make_report(
        {file("a.json", of_suite("programs", R"({"name": "programs/shade", "ok": false,
            "params": {"program": "shade"}, "metrics": {"error": "no such type"}})"))});
    EXPECT_FALSE(report.is_good);
    EXPECT_NE(report.text.find("WRONG: programs/shade: no such type\n"), std::string::npos);
}

TEST_F(Table, CountsTestsAndNamesThoseThatFailed) {
    const Report report = make_report({file("tests.json", of_suite("tests", R"(
        {"name": "tests/reduce/1_of_1", "params": {}, "ok": false, "metrics":
         {"passed": 7, "failed": ["Reduce.Waits"], "seconds": 3, "why": "status 139"}})"))});
    EXPECT_FALSE(report.is_good);
    EXPECT_EQ(words_of(report.text, "tests/reduce/1_of_1: "),
              (Words{"7", "passed,", "3", "s"}));
    EXPECT_NE(report.text.find("FAILED: Reduce.Waits\n"), std::string::npos);
    EXPECT_NE(report.text.find("WRONG: tests/reduce/1_of_1: status 139\n"), std::string::npos)
        << report.text;
}

// Many contenders, long names and long reasons.
TEST_F(Table, IsAtMostAHundredColumnsWide) {
    std::string cases;
    for (int i = 0; i < 30; ++i)
        cases += (i ? "," : "") +
                 reduce_case("strategy_" + std::to_string(i), R"({"ratio_to_copy": 0.5})");
    std::string why = "needs";
    for (int i = 0; i < 60; ++i) why += " bytes";
    const Report report = make_report(
        {file("a.json", of_suite("reduce", cases,
                                 R"(, "left_out": [{"name": "x", "why": ")" + why + "\"}]"))});
    EXPECT_NE(report.text.find("strategy_29"), std::string::npos);
    std::istringstream lines(report.text);
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 100u) << line;
}

}  // namespace
}  // namespace bench
