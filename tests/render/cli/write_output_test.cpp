// write_output_test.cpp - processes that are killed at random moments of writing a file.
#include "cli/write_output.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <random>
#include <thread>

#include "cli/interrupt.hpp"
#include "program.hpp"
#include "temporary_folder.hpp"

namespace render {
namespace {

constexpr int kKills = 50;
constexpr size_t kBytes = size_t{4} << 20;

// Writes the file as rsh-render does, and ends as it does.
pid_t start_writer(const std::string& path, const std::string& bytes) {
    const pid_t child = fork();
    if (child != 0) return child;
    std::signal(SIGINT, SIG_DFL);  // a shell's background job ignores it
    handle_signals();
    try {
        write_output(path, bytes);
    } catch (const Interrupted& end) {
        _exit(128 + end.signal);
    } catch (...) {
        _exit(1);
    }
    _exit(0);
}

int wait_for(pid_t child) {
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status);
}

std::chrono::duration<double> time_of_a_write(const std::string& path,
                                              const std::string& bytes) {
    const auto start = std::chrono::steady_clock::now();
    EXPECT_EQ(wait_for(start_writer(path, bytes)), 0);
    return std::chrono::steady_clock::now() - start;
}

TEST(WriteOutput, KilledAtAnyMomentLeavesOneOfTheTwoFilesWhole) {
    const TemporaryFolder folder;
    const std::string path = folder.path("a.png");
    std::string now(kBytes, 'a'), next(kBytes, 'b');
    auto whole = time_of_a_write(path, now);
    for (int i = 0; i < 4; ++i) whole = std::min(whole, time_of_a_write(path, now));
    std::mt19937 random(1);
    std::uniform_real_distribution<double> share(0.0, 1.1);
    int statuses[3] = {0, 0, 0};
    for (int i = 0; i < kKills; ++i) {
        const int signal = i % 3 == 0 ? SIGKILL : i % 3 == 1 ? SIGTERM : SIGINT;
        const pid_t child = start_writer(path, next);
        const auto pause = share(random) * whole;
        std::this_thread::sleep_for(pause);
        kill(child, signal);
        const int status = wait_for(child);
        const std::string found = content(path);
        ASSERT_TRUE(found == now || found == next)
            << "kill " << i << " by " << signal << " after " << pause.count()
            << " s: neither the old nor the new file, but " << found.size() << " bytes";
        if (status == 0) {
            EXPECT_EQ(found, next) << "kill " << i << ": status 0, but the old file";
        }
        if (status > 0 && status < 1000) {
            EXPECT_EQ(status, 128 + signal);
            EXPECT_EQ(found, now)
                << "kill " << i << ": status " << status << ", but the new file";
        }
        ++statuses[status == 0 ? 0 : status < 1000 ? 1 : 2];
        if (found == next) std::swap(now, next);
    }
    std::printf(
        "%d ended with status 0, %d by a signal that they noticed, %d by one that they could "
        "not\n",
        statuses[0], statuses[1], statuses[2]);
    size_t left = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder.path("")))
        left += entry.path() != path;
    EXPECT_LE(left, static_cast<size_t>(statuses[2])) << "only who cannot notice leaves a rest";
}

TEST(WriteOutput, ASecondSignalEndsTheProcess) {
    int ends[2];
    ASSERT_EQ(pipe(ends), 0);
    const pid_t child = fork();
    if (child == 0) {
        handle_signals();
        std::raise(SIGTERM);
        const char noted = static_cast<char>(pending_signal());
        if (write(ends[1], &noted, 1) != 1) _exit(1);
        std::raise(SIGTERM);
        _exit(0);
    }
    char noted = 0;
    EXPECT_EQ(read(ends[0], &noted, 1), 1);
    EXPECT_EQ(noted, SIGTERM);
    EXPECT_EQ(wait_for(child), 1000 + SIGTERM);
    close(ends[0]);
    close(ends[1]);
}

}  // namespace
}  // namespace render
