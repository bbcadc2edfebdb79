#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>
#include <utility>

namespace raytree::inspector {

/// Does work in a thread of its own: what may take longer than a window may stand still. What is
/// asked for last is what is wanted: older work is told to stop, and its answer is dropped.
template <class Answer> class NewestWork {
  public:
    /// May throw once it has been told to stop, and not otherwise.
    using Work = std::function<Answer(std::stop_token)>;

    NewestWork() : thread_([this] { run(); }) {}
    ~NewestWork() {
        {
            const std::lock_guard lock(mutex_);
            ending_ = true;
            stop_.request_stop();
        }
        asked_.notify_one();
        thread_.join();
    }

    void ask(Work work) {
        {
            const std::lock_guard lock(mutex_);
            stop_.request_stop();
            stop_ = {};
            work_ = std::move(work);
            answer_.reset();
        }
        asked_.notify_one();
    }

    /// The answer to what was asked for last, once; waits for it no longer than `patience`.
    std::optional<Answer> take(std::chrono::milliseconds patience) {
        std::unique_lock lock(mutex_);
        answered_.wait_for(lock, patience, [this] { return answer_.has_value(); });
        return std::exchange(answer_, std::nullopt);
    }

  private:
    void run() {
        std::unique_lock lock(mutex_);
        while (true) {
            asked_.wait(lock, [this] { return work_ || ending_; });
            if (ending_) {
                return;
            }
            const Work work = std::exchange(work_, nullptr);
            const std::stop_token stop = stop_.get_token();
            lock.unlock();
            std::optional<Answer> answer = answer_of(work, stop);
            lock.lock();
            if (!stop.stop_requested()) {
                answer_ = std::move(answer);
                answered_.notify_one();
            }
        }
    }

    static std::optional<Answer> answer_of(const Work& work, const std::stop_token& stop) {
        try {
            return work(stop);
        } catch (...) {
            if (!stop.stop_requested()) {
                throw;
            }
            return std::nullopt;
        }
    }

    std::mutex mutex_;
    std::condition_variable asked_, answered_;
    Work work_;                     ///< guarded by mutex_, as all below
    std::stop_source stop_;         ///< of the work asked for last
    std::optional<Answer> answer_;  ///< to it
    bool ending_ = false;
    std::thread thread_;
};

}  // namespace raytree::inspector
