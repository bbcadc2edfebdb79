#include "state/tree_worker.h"

#include "tree/explain.h"
#include "tree/record.h"

namespace raytree::inspector {
namespace {

TracedPixel traced(std::shared_ptr<const Document> document, Pixel pixel) {
    TracedPixel result{std::move(document), pixel, nullptr, {}};
    try {
        auto tree = std::make_shared<PixelTree>();
        tree->tree = record_tree(result.document->world(), pixel.i, pixel.j);
        tree->tree.scene_sha256 = result.document->loaded().sha256;
        tree->children = children_of(tree->tree);
        result.tree = std::move(tree);
    } catch (const InputError& error) {
        result.failure = error.what();
    }
    return result;
}

}  // namespace

TreeWorker::TreeWorker() : thread_([this] { run(); }) {}

TreeWorker::~TreeWorker() {
    {
        const std::lock_guard lock(mutex_);
        ending_ = true;
    }
    asked_.notify_one();
    thread_.join();
}

void TreeWorker::ask(std::shared_ptr<const Document> document, Pixel pixel) {
    {
        const std::lock_guard lock(mutex_);
        question_ = Question{std::move(document), pixel};
        answer_.reset();
    }
    asked_.notify_one();
}

std::optional<TracedPixel> TreeWorker::take(std::chrono::milliseconds patience) {
    std::unique_lock lock(mutex_);
    answered_.wait_for(lock, patience, [this] { return answer_.has_value(); });
    return std::exchange(answer_, std::nullopt);
}

void TreeWorker::run() {
    std::unique_lock lock(mutex_);
    while (true) {
        asked_.wait(lock, [this] { return question_ || ending_; });
        if (ending_) {
            return;
        }
        const Question question = *std::exchange(question_, std::nullopt);
        lock.unlock();
        TracedPixel result = traced(question.document, question.pixel);
        lock.lock();
        if (!question_) {  // else somebody has asked anew meanwhile
            answer_ = std::move(result);
            answered_.notify_one();
        }
    }
}

}  // namespace raytree::inspector
