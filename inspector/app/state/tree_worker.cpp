#include "state/tree_worker.h"

namespace raytree::inspector {

TracedPixel TreeWorker::answer(const Question& question) {
    const auto& [shown, with] = question;
    TracedPixel result{shown.document, shown.pixel, nullptr, {}};
    try {
        result.tree =
            std::make_shared<const PixelTree>(with ? laid_over(shown, *with) : tree_from(shown));
    } catch (const InputError& error) {
        result.failure = error.what();
    }
    return result;
}

TreeWorker::TreeWorker() : thread_([this] { run(); }) {}

TreeWorker::~TreeWorker() {
    {
        const std::lock_guard lock(mutex_);
        ending_ = true;
    }
    asked_.notify_one();
    thread_.join();
}

void TreeWorker::ask(TreeSource shown, std::optional<Comparison> with) {
    {
        const std::lock_guard lock(mutex_);
        question_ = Question{std::move(shown), std::move(with)};
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
        TracedPixel result = answer(question);
        lock.lock();
        if (!question_) {  // else somebody has asked anew meanwhile
            answer_ = std::move(result);
            answered_.notify_one();
        }
    }
}

}  // namespace raytree::inspector
