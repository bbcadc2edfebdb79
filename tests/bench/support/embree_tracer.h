#pragma once

#include <memory>

#include "support/picture_steps.h"
#include "trace/render.h"

/// A tracer in float as one would write it over Embree: its hits, and raytree's own formulas of
/// illumination.
namespace raytree::bench {

class EmbreeTracer {
  public:
    /// The scene must outlive the tracer.
    explicit EmbreeTracer(const Scene& scene);
    ~EmbreeTracer();

    /// Nothing: it can be traced. Otherwise why not.
    static std::string why_not(const Scene& scene);

    Picture render() const;
    /// The rays of one pixel's tree, shadow rays left out.
    Steps<float> steps(int i, int j) const;

  private:
    struct Data;
    std::unique_ptr<Data> data_;
};

}  // namespace raytree::bench
