#include "trace/reason.h"

namespace raytree {
namespace {

constexpr std::array<std::string_view, 4> kind_words = {"primary", "reflected", "refracted",
                                                        "shadow"};

}  // namespace

const std::array<ReasonText, reason_count>& reason_texts() {
    static constexpr std::array<ReasonText, reason_count> texts = {{
        {Reason::light_behind_surface, "light_behind_surface",
         "the light is behind the surface: n · L ≤ 0, so it adds nothing here", "Shadow rays"},
        {Reason::surface_unlit, "surface_unlit",
         "nothing to light: kd and ks are 0 in every channel", "Shadow rays"},
        {Reason::not_reflective, "not_reflective", "the surface does not reflect: kr is 0",
         "Where a tree ends"},
        {Reason::not_transmissive, "not_transmissive", "the surface lets nothing through: kt is 0",
         "Where a tree ends"},
        {Reason::total_internal_reflection, "total_internal_reflection",
         "total internal reflection: sin² of the refracted angle would exceed 1",
         "The refracted direction"},
        {Reason::max_depth, "max_depth", "the tree is already max_depth levels deep here",
         "Where a tree ends"},
        {Reason::low_intensity, "low_intensity",
         "its share of the pixel would be below min_weight in every channel", "Where a tree ends"},
        {Reason::ray_budget, "ray_budget", "the tree already holds ray_budget rays",
         "Where a tree ends"},
        {Reason::no_intersection, "no_intersection", "it meets nothing: the background is seen",
         "Where a tree ends"},
        {Reason::max_distance, "max_distance",
         "it meets nothing before its path from the eye is max_distance long", "Where a tree ends"},
        {Reason::opaque, "opaque", "the surface neither reflects nor lets light through",
         "Where a tree ends"},
    }};
    return texts;
}

const ReasonText& text_of(Reason reason) {
    return reason_texts()[static_cast<std::size_t>(reason)];
}

std::string_view word_of(Reason reason) { return text_of(reason).word; }

std::string_view word_of(RayKind kind) { return kind_words[static_cast<std::size_t>(kind)]; }

std::optional<Reason> reason_from(std::string_view word) {
    for (const ReasonText& text : reason_texts()) {
        if (text.word == word) {
            return text.reason;
        }
    }
    return std::nullopt;
}

std::optional<RayKind> ray_kind_from(std::string_view word) {
    for (std::size_t i = 0; i < kind_words.size(); ++i) {
        if (kind_words[i] == word) {
            return static_cast<RayKind>(i);
        }
    }
    return std::nullopt;
}

}  // namespace raytree
