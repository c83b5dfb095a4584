// document_test.cpp - the file is whole after every case.
#include "document.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace bench {
namespace {

class DocumentFile : public ::testing::Test {
protected:
    DocumentFile() { std::filesystem::remove(path_); }
    ~DocumentFile() override { std::filesystem::remove(path_); }

    nlohmann::json read() const { return nlohmann::json::parse(std::ifstream(path_)); }

    const std::string path_ = ::testing::TempDir() + "rsh_bench_document_test.json";
};

TEST_F(DocumentFile, HasEachCaseAsSoonAsItIsThere) {
    Document document({{"suite", "frame"}}, path_);
    EXPECT_EQ(read()["cases"].size(), 0u);
    document.add({"a", {{"n", 1}}, {{"ms", 2.5}}});
    EXPECT_EQ(read()["cases"][0]["metrics"]["ms"], 2.5);
    document.add({"b", {}, {}, false});
    EXPECT_EQ(read()["cases"][1]["ok"], false);
    EXPECT_EQ(read()["suite"], "frame");
    EXPECT_EQ(read()["format_version"], 1);
    EXPECT_EQ(document.wrong_count(), 1u);
    EXPECT_EQ(document.cases().size(), 2u);
}

TEST_F(DocumentFile, SaysWhatWasLeftOutAndWhy) {
    Document document({{"suite", "reduce"}}, path_);
    document.leave_out("large", "does not fit");
    EXPECT_EQ(read()["left_out"],
              nlohmann::json::parse(R"([{"name": "large", "why": "does not fit"}])"));
    EXPECT_EQ(document.left_out_count(), 1u);
}

TEST(Document, RefusesAPlaceThatIsNone) {
    EXPECT_THROW(Document({}, "/no/such/folder/file.json"), std::runtime_error);
}

}  // namespace
}  // namespace bench
