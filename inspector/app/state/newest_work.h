#pragma once

#include <chrono>
#include <condition_variable>
#include <exception>
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
    /// What it throws once it has been told to stop is dropped with its answer.
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
            thrown_ = nullptr;
        }
        asked_.notify_one();
    }

    /// The answer to what was asked for last, once; waits for it no longer than `patience`. Throws
    /// what the work has thrown.
    std::optional<Answer> take(std::chrono::milliseconds patience) {
        std::unique_lock lock(mutex_);
        answered_.wait_for(lock, patience, [this] { return answer_ || thrown_; });
        if (thrown_) {
            std::rethrow_exception(std::exchange(thrown_, nullptr));
        }
        return std::exchange(answer_, std::nullopt);
    }

    /// Until the answer to what was asked for last can be taken. For one thread at a time.
    void wait() {
        std::unique_lock lock(mutex_);
        answered_.wait(lock, [this] { return answer_ || thrown_; });
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
            std::optional<Answer> answer;
            std::exception_ptr thrown;
            try {
                answer = work(stop);
            } catch (...) {
                thrown = std::current_exception();
            }
            lock.lock();
            if (!stop.stop_requested()) {
                answer_ = std::move(answer);
                thrown_ = thrown;
                answered_.notify_one();
            }
        }
    }

    std::mutex mutex_;
    std::condition_variable asked_, answered_;
    Work work_;                     ///< guarded by mutex_, as all below
    std::stop_source stop_;         ///< of the work asked for last
    std::optional<Answer> answer_;  ///< to it
    std::exception_ptr thrown_;     ///< instead of an answer
    bool ending_ = false;
    std::thread thread_;
};

}  // namespace raytree::inspector
