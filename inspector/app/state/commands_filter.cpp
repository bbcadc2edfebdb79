#include <array>
#include <charconv>

#include "state/command_groups.h"

namespace raytree::inspector {
namespace {

constexpr std::array<double, 8> weights = {0, 0.001, 0.003, 0.01, 0.03, 0.1, 0.3, 1};

[[noreturn]] void misuse(std::string_view found) {
    throw InputError("", "filter.set",
                     "'" + std::string(found) +
                         "' is none of: full, dimmed or hidden, and then kind, level, light or "
                         "object with its name");
}

std::string_view take_word(std::string_view& text) {
    const std::size_t end = std::min(text.find(' '), text.size());
    const std::string_view word = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    return word;
}

Shown shown_from(std::string_view word) {
    for (const Shown shown : {Shown::full, Shown::dimmed, Shown::hidden}) {
        if (word_of(shown) == word) {
            return shown;
        }
    }
    misuse(word);
}

RayGroup::By by_from(std::string_view word) {
    using By = RayGroup::By;
    for (const By by : {By::kind, By::level, By::light, By::object}) {
        if (word_of(by) == word) {
            return by;
        }
    }
    misuse(word);
}

/// "dimmed object glass ball"
void set_group(State& state, std::string_view argument) {
    const Shown shown = shown_from(take_word(argument));
    const RayGroup::By by = by_from(take_word(argument));
    if (argument.empty() || (by == RayGroup::By::kind && !ray_kind_from(argument))) {
        misuse(argument);
    }
    const RayGroup group{by, std::string(argument)};
    state.change_look([&](Look& look) { look.filter.set(group, shown); });
}

/// "0.01", or "0.01 dimmed"
void set_weight(State& state, std::string_view argument) {
    const std::string_view number = take_word(argument);
    double weight = 0;
    const char* const end = number.data() + number.size();
    const auto read = std::from_chars(number.data(), end, weight);
    if (read.ec != std::errc() || read.ptr != end || !(weight >= 0 && weight <= 1)) {
        throw InputError(
            "", "filter.weight",
            "a share of the pixel is from 0 to 1; found '" + std::string(number) + "'");
    }
    const Shown lighter = argument.empty() ? Shown::hidden : shown_from(argument);
    state.change_look([&](Look& look) {
        look.filter.least_weight = weight;
        look.filter.lighter = lighter;
    });
}

/// The next larger or smaller threshold; the same where there is none.
double next_weight(const State& state, int by) {
    const double now = state.look().filter.least_weight;
    double next = now;
    for (const double weight : weights) {
        if (by > 0 ? weight > now && next == now : weight < now) {
            next = weight;
        }
    }
    return next;
}
template <int by> void change_weight(State& state, std::string_view) {
    const double weight = next_weight(state, by);
    state.change_look([&](Look& look) { look.filter.least_weight = weight; });
}
template <int by> bool can_change_weight(const State& state) {
    return next_weight(state, by) != state.look().filter.least_weight;
}

void show_all(State& state, std::string_view) {
    state.change_look([](Look& look) { look.filter = {}; });
}
bool has_filter(const State& state) { return !state.look().filter.empty(); }

void dim_lighter(State& state, std::string_view) {
    state.change_look([](Look& look) {
        look.filter.lighter = look.filter.lighter == Shown::hidden ? Shown::dimmed : Shown::hidden;
    });
}
bool lighter_are_dimmed(const State& state) { return state.look().filter.lighter == Shown::dimmed; }

void show_tab(State& state, std::string_view) {
    TreePane pane = state.tree_pane();
    pane.tab = TreePane::Tab::filter;
    state.change_tree_pane(pane);
}
bool tab_is_shown(const State& state) { return state.tree_pane().tab == TreePane::Tab::filter; }

constexpr Command table[] = {
    {"tab.filter", "Filter", "Choose rays…", "Alt+4",
     "Shows which kinds, levels, lights and objects there are: each can be dimmed or hidden.", none,
     show_tab, nullptr, tab_is_shown},
    {"filter.set", "", "Dim or hide rays", "",
     "Shows, dims or hides rays: full, dimmed or hidden; kind, level, light or object; its name.",
     Argument::text, set_group},
    {"filter.weight", "", "Least weight", "",
     "Hides, or dims, the rays whose share of the pixel is less.", Argument::text, set_weight},
    {"filter.more",
     "Filter",
     "Fewer of the light rays",
     "Ctrl+.",
     "Leaves out more rays whose share of the pixel is small.",
     none,
     change_weight<1>,
     can_change_weight<1>,
     nullptr,
     {},
     true},
    {"filter.less", "Filter", "More of the light rays", "Ctrl+,",
     "Brings back rays whose share of the pixel is small.", none, change_weight<-1>,
     can_change_weight<-1>},
    {"filter.dim_light", "Filter", "Dim the light rays only", "",
     "Dims the rays whose share of the pixel is small instead of hiding them.", none, dim_lighter,
     nullptr, lighter_are_dimmed},
    {"filter.clear",
     "Filter",
     "Show all rays",
     "Ctrl+Shift+A",
     "Shows every ray in full again.",
     none,
     show_all,
     has_filter,
     nullptr,
     {},
     true},
};

}  // namespace

std::span<const Command> filter_commands() { return table; }

}  // namespace raytree::inspector
