#pragma once

#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "state/contrast.h"

namespace raytree::inspector {

struct TracedPixel {
    std::shared_ptr<const Document> document;
    Pixel pixel;
    std::shared_ptr<const PixelTree> tree;  ///< null where it has no finite intensity
    std::string failure;                    ///< why
};

/// Traces trees in a thread of its own: one of a million rays takes longer than a window may stand
/// still. Of several pixels asked for, only the last is traced once the thread is free.
class TreeWorker {
  public:
    TreeWorker();
    ~TreeWorker();

    /// `with`: what the tree is laid over, if anything.
    void ask(TreeSource shown, std::optional<Comparison> with = std::nullopt);
    /// The answer to the last question, once; waits for it no longer than `patience`.
    std::optional<TracedPixel> take(std::chrono::milliseconds patience);

  private:
    struct Question {
        TreeSource shown;
        std::optional<Comparison> with;
    };
    static TracedPixel answer(const Question& question);
    void run();

    std::mutex mutex_;
    std::condition_variable asked_, answered_;
    std::optional<Question> question_;   ///< guarded by mutex_, as all below
    std::optional<TracedPixel> answer_;  ///< to the last question
    bool ending_ = false;
    std::thread thread_;
};

}  // namespace raytree::inspector
