#include "scene/progress.h"

#include <utility>

namespace raytree {
namespace {

thread_local ProgressListener* listener = nullptr;

}  // namespace

ProgressListener::ProgressListener(Hear hear)
    : hear_(std::move(hear)), outer_(std::exchange(listener, this)) {}

ProgressListener::~ProgressListener() { listener = outer_; }

void tell_progress(std::string_view doing, double share) {
    if (listener != nullptr) {
        listener->hear_(doing, share);
    }
}

}  // namespace raytree
