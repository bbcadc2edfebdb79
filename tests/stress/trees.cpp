#include <cmath>
#include <filesystem>
#include <memory>
#include <mutex>
#include <numeric>

#include "formats/scene_file.h"
#include "stress.h"
#include "tree/error_bounds.h"
#include "tree/record.h"

namespace raytree::stress {
namespace {

constexpr int width = 97;
constexpr int height = 61;
constexpr std::uint64_t pixels = std::uint64_t{width} * height;

/// A scene in both arithmetics, made when its first pixel is asked for.
struct Subject {
    std::string file;
    std::once_flag made;
    std::unique_ptr<LoadedScene> loaded;
    std::unique_ptr<World<double>> own;
    std::unique_ptr<World<Quad>> reference;

    void make() {
        std::call_once(made, [this] {
            SceneOptions options;
            options.size = {width, height};
            loaded = std::make_unique<LoadedScene>(load_scene(file, options));
            own = std::make_unique<World<double>>(loaded->scene);
            reference = std::make_unique<World<Quad>>(loaded->scene);
        });
    }
};

bool is_scene(const std::filesystem::path& file) {
    const std::string name = file.filename().string();
    if (name.find(".tree.") != std::string::npos || name == "lesson.json") {
        return false;
    }
    const auto extension = file.extension();
    return extension == ".json" || extension == ".nff" || extension == ".txt";
}

/// Every scene of the project, and those of others where they are.
std::vector<std::unique_ptr<Subject>>& subjects() {
    static std::vector<std::unique_ptr<Subject>> list = [] {
        std::vector<std::string> files;
        for (const char* folder :
             {RAYTREE_DATA_DIR "/scenes", RAYTREE_LESSONS_DIR, RAYTREE_SHARED_DATA_DIR}) {
            std::error_code error;
            for (std::filesystem::recursive_directory_iterator entry(folder, error), end;
                 entry != end && !error; entry.increment(error)) {
                if (is_scene(entry->path())) {
                    files.push_back(entry->path().string());
                }
            }
        }
        std::ranges::sort(files);
        std::vector<std::unique_ptr<Subject>> result;
        for (const std::string& file : files) {
            result.push_back(std::make_unique<Subject>());
            result.back()->file = file;
        }
        return result;
    }();
    return list;
}

/// Compares a ray of both trees: first what it is, then its numbers against their bounds.
class Comparison {
  public:
    Comparison(const RayTree<double>& own, const RayTree<Quad>& exact,
               const std::vector<RayBounds>& bounds)
        : own_(own), exact_(exact), bounds_(bounds) {}

    /// The first ray that is or goes another way; the number of rays where the shapes agree.
    std::size_t first_difference() const {
        const std::size_t rays = std::min(own_.rays.size(), exact_.rays.size());
        for (std::size_t k = 0; k < rays; ++k) {
            if (!same_shape(own_.rays[k], exact_.rays[k])) {
                return k;
            }
        }
        return rays == std::max(own_.rays.size(), exact_.rays.size()) ? rays : rays - 1;
    }

    /// Whether the ray, or one on its way from the eye, is marked.
    bool is_undecided(std::size_t k) const {
        for (std::optional<std::size_t> ray = k; ray; ray = own_.rays[*ray].parent) {
            if (!bounds_[*ray].doubts.empty()) {
                return true;
            }
        }
        return false;
    }

    /// The largest error as a share of its bound, and of what.
    double worst(std::string& what) {
        for (std::size_t k = 0; k < own_.rays.size(); ++k) {
            compare(own_.rays[k], exact_.rays[k], bounds_[k]);
        }
        what = what_;
        return worst_;
    }

  private:
    static bool same_shape(const TreeRay<double>& a, const TreeRay<Quad>& b) {
        const auto same_reasons = [](const auto& x, const auto& y) {
            return std::ranges::equal(x, y, [](const Skipped& p, const Skipped& q) {
                return p.kind == q.kind && p.light == q.light && p.reason == q.reason;
            });
        };
        const auto blocker = [](const auto& ray) {
            return ray.shadow && ray.shadow->blocked_by ? ray.shadow->blocked_by->object : "";
        };
        return a.kind == b.kind && a.parent == b.parent && a.termination == b.termination &&
               a.hit.has_value() == b.hit.has_value() &&
               (!a.hit || (a.hit->object == b.hit->object && a.hit->side == b.hit->side)) &&
               same_reasons(a.skipped, b.skipped) && blocker(a) == blocker(b);
    }

    void judge(double error, double bound, std::size_t ray, const char* what) {
        if (error == 0 && bound == 0) {
            return;
        }
        const double share = error / bound;
        if (!(share <= worst_)) {
            worst_ = share;
            what_ = std::string(what) + " of ray " + std::to_string(ray);
        }
    }
    void judge(double a, Quad b, double bound, std::size_t ray, const char* what) {
        judge(static_cast<double>(abs(Quad(a) - b)), bound, ray, what);
    }
    void judge(const Vec3<double>& a, const Vec3<Quad>& b, double bound, std::size_t ray,
               const char* what) {
        judge(static_cast<double>(length<Quad>(vector_cast<Quad>(a) - b)), bound, ray, what);
    }
    void judge(const Rgb<double>& a, const Rgb<Quad>& b, const Rgb<double>& bound, std::size_t ray,
               const char* what) {
        judge(a.r, b.r, bound.r, ray, what);
        judge(a.g, b.g, bound.g, ray, what);
        judge(a.b, b.b, bound.b, ray, what);
    }

    void compare(const TreeRay<double>& a, const TreeRay<Quad>& b, const RayBounds& bound) {
        judge(a.origin, b.origin, bound.origin, a.id, "origin");
        judge(a.direction, b.direction, bound.direction, a.id, "direction");
        if (a.shadow) {
            if (a.shadow->distance) {
                judge(*a.shadow->distance, *b.shadow->distance, bound.distance, a.id, "distance");
            }
            if (a.shadow->blocked_by) {
                judge(a.shadow->blocked_by->t, b.shadow->blocked_by->t, bound.hit.t, a.id,
                      "t of the blocker");
            }
            judge(a.shadow->transmittance, b.shadow->transmittance, bound.transmittance, a.id,
                  "transmittance");
        } else {
            judge(a.weight, b.weight, bound.weight, a.id, "weight");
            judge(a.attenuation, b.attenuation, bound.attenuation, a.id, "attenuation");
            judge(a.intensity, b.intensity, bound.intensity, a.id, "intensity");
        }
        judge(a.ambient, b.ambient, bound.ambient, a.id, "ambient");
        judge(a.diffuse, b.diffuse, bound.diffuse, a.id, "diffuse");
        judge(a.specular, b.specular, bound.specular, a.id, "specular");
        if (a.hit) {
            judge(a.hit->t, b.hit->t, bound.hit.t, a.id, "t");
            judge(a.hit->point, b.hit->point, bound.hit.point, a.id, "point");
            judge(a.hit->normal, b.hit->normal, bound.hit.normal, a.id, "normal");
            judge(a.hit->cos_incident, b.hit->cos_incident, bound.hit.cos_incident, a.id,
                  "cos_incident");
            if (a.hit->interface) {
                judge(a.hit->interface->sin2_transmitted, b.hit->interface->sin2_transmitted,
                      bound.hit.sin2_transmitted, a.id, "sin2_transmitted");
            }
        }
    }

    const RayTree<double>& own_;
    const RayTree<Quad>& exact_;
    const std::vector<RayBounds>& bounds_;
    double worst_ = 0;
    std::string what_;
};

void try_pixel(Subject& subject, int i, int j, Tally& tally) {
    subject.make();
    const RayTree<double> own = record_tree(*subject.own, i, j);
    const RayTree<Quad> exact = record_tree(*subject.reference, i, j);
    const auto bounds =
        error_bounds(*subject.own, *subject.reference, own, Real<double>::unit_roundoff);
    Comparison comparison(own, exact, bounds);
    const std::size_t different = comparison.first_difference();
    Outcome& outcome = tally.in_double;
    std::string what = "its shape differs, unmarked, at ray " + std::to_string(different);
    bool good = true;
    if (different < std::max(own.rays.size(), exact.rays.size())) {
        good = comparison.is_undecided(different);
        outcome.undecided += good ? 1 : 0;
        outcome.wrong += good ? 0 : 1;
    } else {
        const double share = comparison.worst(what);
        // A decision that went one way in both hides nothing: bounds hold for that way.
        good = outcome.judge(share);
        what += ": " + std::to_string(share) + " of its bound";
    }
    if (!good) {
        tally.describe<double>([&](std::ostream& out) {
            out << subject.file << " at " << width << 'x' << height << ", pixel " << i << ',' << j
                << ": " << what;
        });
    }
}

/// The pixels of all scenes in an order in which the first few are of all scenes.
Tally run_range(std::uint64_t first, std::uint64_t trials) {
    const std::uint64_t all = subjects().size() * pixels;
    std::uint64_t stride = 1'000'003;
    while (std::gcd(stride, all) != 1) {
        ++stride;
    }
    Tally tally;
    for (; tally.trials < trials && first + tally.trials < all; ++tally.trials) {
        const std::uint64_t place = (first + tally.trials) % all * stride % all;
        const std::uint64_t pixel = place % pixels;
        try_pixel(*subjects()[place / pixels], static_cast<int>(pixel % width),
                  static_cast<int>(pixel / width), tally);
    }
    return tally;
}

}  // namespace

Row trees() {
    Row row{
        "trees",
        "the ray trees of every scene in `data/`, `lessons/` and, where it is, the shared data, "
        "at every pixel of 97 x 61",
        "trees",
        "the same shape as in the reference arithmetic, or marked as undecided there; every "
        "number within its bound",
        "its bound",
        100,
        subjects().size() * pixels,
        50,
        {},
        {}};
    row.run_range = run_range;
    return row;
}

}  // namespace raytree::stress
