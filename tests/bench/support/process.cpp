#include "support/process.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <stdexcept>

#include "support/bench.h"

namespace raytree::bench {
namespace {

double seconds(const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
}

[[noreturn]] void become(const std::vector<std::string>& arguments, int output) {
    std::vector<char*> argv;
    for (const std::string& argument : arguments) {
        argv.push_back(const_cast<char*>(argument.c_str()));
    }
    argv.push_back(nullptr);
    dup2(output, STDOUT_FILENO);
    dup2(output, STDERR_FILENO);
    execvp(argv[0], argv.data());
    _exit(127);
}

}  // namespace

ProcessRun run_process(const std::vector<std::string>& arguments) {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) {
        throw std::runtime_error("no pipe could be made");
    }
    ProcessRun run;
    const double begin = wall_seconds();
    const pid_t child = fork();
    if (child == 0) {
        become(arguments, ends[1]);
    }
    close(ends[1]);
    char buffer[4096];
    for (ssize_t n = 0; (n = read(ends[0], buffer, sizeof buffer)) > 0;) {
        run.said.append(buffer, static_cast<std::size_t>(n));
    }
    close(ends[0]);
    int status = 0;
    rusage usage{};
    if (child < 0 || wait4(child, &status, 0, &usage) != child) {
        throw std::runtime_error(arguments[0] + " could not be run");
    }
    run.wall = wall_seconds() - begin;
    run.processor = seconds(usage.ru_utime) + seconds(usage.ru_stime);
    run.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128;
    return run;
}

bool on_path(const std::string& program) {
    const char* const path = std::getenv("PATH");
    std::istringstream folders(path ? path : "");
    for (std::string folder; std::getline(folders, folder, ':');) {
        if (access((folder + '/' + program).c_str(), X_OK) == 0) {
            return true;
        }
    }
    return false;
}

std::string programs_folder() {
    return std::filesystem::read_symlink("/proc/self/exe").parent_path().parent_path().string();
}

TemporaryFolder::TemporaryFolder() {
    std::string path = (std::filesystem::temp_directory_path() / "raytree-bench-XXXXXX").string();
    if (!mkdtemp(path.data())) {
        throw std::runtime_error("no temporary folder could be made");
    }
    path_ = path;
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code none;
    std::filesystem::remove_all(path_, none);
}

}  // namespace raytree::bench
