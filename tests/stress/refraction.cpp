#include "stress.h"
#include "trace/shading.h"

namespace raytree::stress {
namespace {

/// A ray that meets a surface between two media, the indices 1 to 10^3 times one another.
struct Trial {
    double eta1 = 1, eta2 = 1;
    Vec3<double> direction{}, normal{};
};

/// The sine of an angle of incidence: anything, nearly 0, nearly 1, or within 10^-15 of the
/// critical angle's.
double any_sine(Random& random, double critical) {
    switch (random.below(4)) {
        case 0:
            return random.uniform(0, 1);
        case 1:
            return random.log_uniform(1e-12, 1);
        case 2:
            return std::sqrt(1 - random.log_uniform(1e-16, 1));
        default:
            return critical < 1
                       ? critical * (1 + random.log_uniform(1e-16, 1e-3) * random.uniform(-1, 1))
                       : random.uniform(0, 1);
    }
}

Trial trial(Random& random) {
    Trial result;
    const double index = random.chance(0.1) ? 1 : random.log_uniform(1, 1e3);
    (random.chance(0.5) ? result.eta1 : result.eta2) = index;
    const double sine = min_of(any_sine(random, result.eta2 / result.eta1), 1.0);
    result.normal = random.direction();
    const double cosine = std::sqrt((1 - sine) * (1 + sine));
    const Vec3<double> across = random.across(result.normal);
    result.direction =
        UnitVec3<double>::of(along(Vec3<double>(sine * across), -cosine, result.normal));
    return result;
}

/// How far the refracted direction moves when the indices and the components of the ray and of the
/// normal do, relatively.
double condition(double eta, double sine, double cos_transmitted) {
    return 1 + 2 * eta + eta * eta * (sine * sine + sine) / cos_transmitted;
}

template <class T, class Ref> double distance(const UnitVec3<T>& found, const Vec3<Ref>& exact) {
    return static_cast<double>(length<Ref>(vector_cast<Ref>(found.vec()) - exact));
}

template <class T> class Check {
  public:
    using Ref = Reference<T>;

    Check(const Trial& trial, Tally& tally)
        : trial_(trial),
          tally_(tally),
          eta1_(static_cast<T>(trial.eta1)),
          eta2_(static_cast<T>(trial.eta2)),
          d_(UnitVec3<T>::of(vector_cast<T>(trial.direction))),
          n_(UnitVec3<T>::of(vector_cast<T>(trial.normal))) {}

    void run() {
        const Snell<T> own = snell(eta1_, eta2_, d_, n_);
        const auto exact_d = vector_cast<Ref>(d_), exact_n = vector_cast<Ref>(n_);
        const Snell<Ref> exact = snell(Ref(eta1_), Ref(eta2_), exact_d, exact_n);
        if (own.total_reflection() != exact.total_reflection()) {
            const T bound = own.error();
            const auto share = static_cast<double>(abs(exact.cos2_transmitted) / Ref(bound));
            tally_.in<T>().undecided += share <= 1 ? 1 : 0;
            judge(share, "total reflection");
            return;
        }
        if (own.total_reflection() || !(own.cos2_transmitted > 0) ||
            !(exact.cos2_transmitted > 0)) {
            return;
        }
        const auto refracted = refracted_direction(own, d_, n_);
        const auto truth = refracted_direction(exact, exact_d, exact_n);
        const double eta = static_cast<double>(eta1_ / eta2_);
        const auto cos_t = static_cast<double>(sqrt(exact.cos2_transmitted));
        const auto sin_i = static_cast<double>(length<Ref>(outer(exact_n, exact_d)));
        const auto cos_i = static_cast<double>(-inner(exact_d, exact_n));
        const double there = condition(eta, sin_i, cos_t);
        judge(distance<T, Ref>(refracted, truth.vec()) / (ulps(4) * there), "direction");
        if (!(cos_i > 0)) {
            return;
        }
        // Out again: what the first refraction was off by passes through the second.
        const double back = condition(1 / eta, eta * sin_i, cos_i);
        const double passes = max_of(1.0, cos_t / cos_i) / eta;
        const double allowed = ulps(4) * (back + passes * there);
        const Vec3<T> reversed = -refracted.vec();
        const Snell<T> onwards = snell(eta2_, eta1_, refracted.vec(), n_);
        const Snell<T> backwards = snell(eta2_, eta1_, reversed, Vec3<T>(-n_));
        if (onwards.total_reflection() || backwards.total_reflection()) {
            // Grazing: it may not come out again where the bounds say so.
            const double moves = 2 * sin_i / eta * ulps(4) * there;
            judge(cos_i * cos_i / (moves + static_cast<double>(onwards.error())), "way out");
            ++tally_.in<T>().undecided;
            return;
        }
        const auto through = refracted_direction(onwards, refracted.vec(), n_);
        const auto returned = refracted_direction(backwards, reversed, Vec3<T>(-n_));
        judge(distance<T, Ref>(through, exact_d) / allowed, "slab");
        judge(distance<T, Ref>(-returned, exact_d) / allowed, "back again");
    }

  private:
    static double ulps(int n) { return 2 * n * static_cast<double>(Real<T>::unit_roundoff); }

    void judge(double share, const char* what) {
        if (!tally_.in<T>().judge(share)) {
            tally_.describe<T>([&](std::ostream& out) {
                out << what << ": from index " << trial_.eta1 << " to " << trial_.eta2 << ", along "
                    << trial_.direction << " at the normal " << trial_.normal << ": " << share
                    << " of what is allowed";
            });
        }
    }

    const Trial& trial_;
    Tally& tally_;
    T eta1_, eta2_;
    Vec3<T> d_, n_;
};

Tally run(Random& random, std::uint64_t trials) {
    Tally tally;
    for (; tally.trials < trials; ++tally.trials) {
        const Trial one = trial(random);
        Check<double>(one, tally).run();
        Check<float>(one, tally).run();
    }
    return tally;
}

}  // namespace

Row refraction() {
    return {"refraction",
            "refraction at all angles, within 10^-15 of the critical one and of grazing; indices 1 "
            "to 10^3; out again through a parallel slab, and back along the refracted ray",
            "rays",
            "total reflection as the reference or within the bound; directions, there and back, "
            "within 4 ulp times the condition number",
            "4 ulp times the condition number",
            20'000,
            10'000'000,
            10'000,
            run};
}

}  // namespace raytree::stress
