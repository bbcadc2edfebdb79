#pragma once

#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "state/document.h"
#include "tree/ray_tree.h"

namespace raytree::inspector {

/// The tree of the chosen pixel and its rays' children.
struct PixelTree {
    RayTree<double> tree;
    std::vector<std::vector<std::size_t>> children;
};

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

    void ask(std::shared_ptr<const Document> document, Pixel pixel);
    /// The answer to the last question, once; waits for it no longer than `patience`.
    std::optional<TracedPixel> take(std::chrono::milliseconds patience);

  private:
    struct Question {
        std::shared_ptr<const Document> document;
        Pixel pixel;
    };
    void run();

    std::mutex mutex_;
    std::condition_variable asked_, answered_;
    std::optional<Question> question_;   ///< guarded by mutex_, as all below
    std::optional<TracedPixel> answer_;  ///< to the last question
    bool ending_ = false;
    std::thread thread_;
};

}  // namespace raytree::inspector
