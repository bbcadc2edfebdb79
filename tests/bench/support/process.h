#pragma once

#include <optional>
#include <string>
#include <vector>

namespace raytree::bench {

/// What running another program took.
struct ProcessRun {
    double wall = 0;       ///< seconds from its start to its end
    double processor = 0;  ///< seconds of processor time, of all its threads
    int code = 0;          ///< its exit code; 127 where it cannot be started
    std::string said;      ///< on standard output and standard error
};

ProcessRun run_process(const std::vector<std::string>& arguments);

/// Whether a program of this name is on the search path.
bool on_path(const std::string& program);

/// The folder of the running program's parent, where `raytree` is.
std::string programs_folder();

/// A folder that is gone when this is.
class TemporaryFolder {
  public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    std::string file(const std::string& name) const { return path_ + '/' + name; }

  private:
    std::string path_;
};

}  // namespace raytree::bench
