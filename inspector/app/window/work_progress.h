#pragma once

#include <atomic>
#include <mutex>
#include <string>

#include "scene/progress.h"

namespace raytree::inspector {

/// How far work in another thread has come, for the window to show; and a way to end it.
class WorkProgress {
  public:
    WorkProgress() { ++running_; }

    /// For the thread that works.
    ProgressListener listener();
    /// The work is done or has been given up.
    void end() { --running_; }
    void cancel() { cancelled_ = true; }

    struct Stage {
        std::string doing;  ///< "reading"; empty as long as nothing has been told
        double share = 0;   ///< 0 to 1
    };
    Stage stage() const;

    /// How much work has been begun and not ended. It must not outlive `main`, and nobody waits for
    /// what was cancelled: while there is some, the program is left at once.
    static int running() { return running_; }

  private:
    static inline std::atomic<int> running_{0};
    std::atomic<bool> cancelled_{false};
    mutable std::mutex mutex_;
    Stage stage_;  ///< guarded by mutex_
};

}  // namespace raytree::inspector
