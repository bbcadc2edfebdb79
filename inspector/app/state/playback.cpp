#include "state/playback.h"

#include <algorithm>
#include <map>

#include "state/details.h"
#include "state/numbers.h"
#include "tree/explain.h"

namespace raytree::inspector {
namespace {

std::string met_text(const TreeRay<double>& ray) {
    if (ray.shadow) {
        return title_of(ray) + ": it " + shadow_text(ray) + ".";
    }
    if (!ray.hit) {
        return title_of(ray) + " meets nothing.";
    }
    return title_of(ray) + " hits " + ray.hit->object + " at t = " + number_text(ray.hit->t) +
           ", on its " + (ray.hit->side == Side::front ? "front" : "back") + ".";
}

std::string skipped_sentence(const RayTree<double>& tree, const TreeRay<double>& ray,
                             const Skipped& skipped) {
    return "From #" + std::to_string(ray.id) + " no " + std::string(word_of(skipped.kind)) +
           " ray is sent" + (skipped.light.empty() ? "" : " to " + skipped.light) + ": " +
           skipped_text(tree, ray, skipped) + ".";
}

std::string returned_text(const Playback& playback, const TreeRay<double>& ray) {
    const RayTree<double>& tree = playback.tree();
    if (!playback.gives_intensity(ray.id)) {
        return title_of(ray) + " returns; the file does not say what.";
    }
    if (ray.shadow) {
        const Rgb<double>& sum = tree.rays[ray.parent.value_or(ray.id)].intensity;
        return title_of(ray) + " adds diffuse + specular = " +
               triple_text(noticed(ray.diffuse + ray.specular, sum)) + ".";
    }
    return title_of(ray) + " returns I = " + triple_text(ray.intensity) +
           (ray.hit ? "." : ", the background.");
}

/// The last event of a whole level stands for all of them.
std::string level_text(const Playback& playback) {
    const TreeEvent& event = playback.event();
    const int level = playback.tree().rays[event.ray].level;
    const std::string which = "level " + std::to_string(level);
    switch (event.kind) {
        case TreeEvent::Kind::sent:
            return "The rays of " + which + " set out.";
        case TreeEvent::Kind::evaluated:
            if (!playback.tree().rays[event.ray].shadow) {
                return "The intensities of " + which + " are evaluated and returned.";
            }
            [[fallthrough]];
        default:
            return "The rays of " + which + " have met what they meet; lights have been asked.";
    }
}

/// "#3 refracted", "#4 shadow → key".
std::string short_title(const TreeRay<double>& ray) {
    return "#" + std::to_string(ray.id) + " " + std::string(word_of(ray.kind)) +
           (ray.shadow ? " → " + ray.shadow->light : "");
}

std::string waiting_for(const Playback& playback, const OpenCall& call) {
    const RayTree<double>& tree = playback.tree();
    if (playback.stage(call.ray) == Stage::sent) {
        return tree.rays[call.ray].shadow ? "what blocks it" : "its hit";
    }
    if (!call.child) {
        return "what comes next";
    }
    return short_title(tree.rays[*call.child]);
}

}  // namespace

Playback::Playback(const std::shared_ptr<const PixelTree>& tree, StepOrder order,
                   const std::vector<std::string>& lights)
    : shown_(tree),
      tree_(tree->grafted == 0 ? std::shared_ptr<const RayTree<double>>(tree, &tree->tree)
                               : std::make_shared<const RayTree<double>>(own_tree(*tree))),
      schedule_(std::make_shared<const Schedule>(*tree_, order, lights)) {}

bool Playback::gives_summands(std::size_t ray) const {
    return shown_->gives(ray, Field::ambient) && shown_->gives(ray, Field::diffuse) &&
           shown_->gives(ray, Field::specular);
}

void Playback::go_to(std::size_t stop) { stop_ = std::min(stop, stops() - 1); }

std::string event_text(const Playback& playback) {
    if (playback.order() == StepOrder::level_by_level) {
        return level_text(playback);
    }
    const TreeEvent& event = playback.event();
    const TreeRay<double>& ray = playback.tree().rays[event.ray];
    switch (event.kind) {
        case TreeEvent::Kind::sent:
            return title_of(ray) + " is sent" +
                   (ray.parent ? " from the hit of #" + std::to_string(*ray.parent) : "") + ".";
        case TreeEvent::Kind::found:
            return met_text(ray);
        case TreeEvent::Kind::skipped:
            return skipped_sentence(playback.tree(), ray, ray.skipped[event.skip]);
        default:
            return returned_text(playback, ray);
    }
}

std::string sent_text(const Playback& playback) {
    const std::vector<TreeRay<double>>& rays = playback.tree().rays;
    std::map<RayKind, std::size_t> sent;
    std::size_t all = 0;
    for (std::size_t k = 0; k < rays.size(); ++k) {
        if (playback.stage(k) != Stage::unsent) {
            ++sent[rays[k].kind];
            ++all;
        }
    }
    std::string text = grouped(static_cast<double>(all)) + (all == 1 ? " ray" : " rays");
    const char* before = " sent so far: ";
    for (const auto& [kind, count] : sent) {
        text += before + grouped(static_cast<double>(count)) + " " + std::string(word_of(kind));
        before = ", ";
    }
    return text;
}

std::vector<CallText> call_texts(const Playback& playback, std::size_t most) {
    std::vector<CallText> texts;
    for (const OpenCall& call : playback.calls()) {
        if (texts.size() == most) {
            break;
        }
        const TreeRay<double>& ray = playback.tree().rays[call.ray];
        const bool has_sum = ray.hit && playback.stage(call.ray) == Stage::found &&
                             playback.gives_summands(call.ray);
        texts.push_back({call.ray, short_title(ray), waiting_for(playback, call),
                         has_sum ? rgb_text(call.sum) : ""});
    }
    return texts;
}

}  // namespace raytree::inspector
