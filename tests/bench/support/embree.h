#pragma once

#include <memory>
#include <span>
#include <vector>

#include "accel/intersector.h"

/// Embree (Debian's libembree-dev), the rival: a library of float intersection.
namespace raytree::bench {

enum class EmbreeMode { fast, robust };

/// A hit as Embree reports it: `t` infinite where there is none.
struct EmbreeHit {
    float t = 0;
    bool met = false;
};

/// A scene of triangles, spheres and cones in Embree, its hierarchy of high quality.
class EmbreeScene {
  public:
    EmbreeScene(const Scene& scene, EmbreeMode mode, int threads = 1);
    ~EmbreeScene();

    /// One ray after the other.
    void closest(std::span<const Query<double>> queries, std::span<EmbreeHit> hits) const;
    void any(std::span<const Query<double>> queries, std::span<EmbreeHit> hits) const;
    /// In packets of 16 (or 8, where that is what it has), told that they are coherent or not.
    void closest_packets(std::span<const Query<double>> queries, std::span<EmbreeHit> hits,
                         bool coherent) const;
    void any_packets(std::span<const Query<double>> queries, std::span<EmbreeHit> hits,
                     bool coherent) const;

    double build_seconds() const;  ///< of processor time
    double bytes() const;          ///< that Embree holds for the scene
    static bool available();

  private:
    struct Data;
    std::unique_ptr<Data> data_;
};

}  // namespace raytree::bench
