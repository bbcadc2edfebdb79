#include <charconv>

#include "state/command_groups.h"

namespace raytree::inspector {
namespace {

bool steps(const State& state) { return state.playback().has_value(); }
bool at_end(const State& state) { return steps(state) && state.playback()->at_end(); }

void start_or_end(State& state, std::string_view) {
    steps(state) ? state.end_stepping() : state.start_stepping();
}

void forward(State& state, std::string_view) {
    state.play(false);
    state.go_to_stop(steps(state) ? state.playback()->stop() + 1 : 0);
}
bool can_go_forward(const State& state) { return has_tree(state) && !at_end(state); }

void back(State& state, std::string_view) {
    state.play(false);
    state.go_to_stop(state.playback()->stop() - 1);
}
bool can_go_back(const State& state) { return steps(state) && state.playback()->stop() > 0; }

void first(State& state, std::string_view) {
    state.play(false);
    state.go_to_stop(0);
}
void last(State& state, std::string_view) {
    state.play(false);
    state.go_to_stop(~std::size_t{0});
}

void go_to(State& state, std::string_view argument) {
    std::size_t stop = 0;
    const char* const end = argument.data() + argument.size();
    const auto read = std::from_chars(argument.data(), end, stop);
    if (read.ec != std::errc() || read.ptr != end || stop == 0) {
        throw InputError("", "step.to",
                         "found '" + std::string(argument) + "', must be a step's number from 1");
    }
    if (const std::size_t last = state.stops(); stop > last) {
        throw InputError("", "step.to",
                         "found " + std::string(argument) + ", must be a step's number from 1 to " +
                             std::to_string(last));
    }
    state.play(false);
    state.go_to_stop(stop - 1);
}

void play(State& state, std::string_view) { state.play(!state.playing()); }
bool plays(const State& state) { return state.playing(); }

template <int percent> void change_pace(State& state, std::string_view) {
    state.set_pace(state.pace() * percent / 100);
}

void by_levels(State& state, std::string_view) {
    state.set_step_order(state.step_order() == StepOrder::depth_first ? StepOrder::level_by_level
                                                                      : StepOrder::depth_first);
}
bool goes_by_levels(const State& state) { return state.step_order() == StepOrder::level_by_level; }

constexpr Command table[] = {
    {"step.mode", "Step", "Step through the tree", "Shift+N",
     "Shows the tree as it is computed, step by step, or all of it again.", none, start_or_end,
     has_tree, steps, "Steps"},
    {"step.forward",
     "Step",
     "Forward",
     ". PgDown",
     "Goes on to what happens next.",
     none,
     forward,
     can_go_forward,
     nullptr,
     {},
     true},
    {"step.back", "Step", "Back", ", PgUp", "Goes back to what happened before.", none, back,
     can_go_back},
    {"step.first", "Step", "First", "Ctrl+Home", "Goes to where the primary ray is sent.", none,
     first, has_tree},
    {"step.last", "Step", "Last", "Ctrl+End", "Goes to where the pixel's intensity is known.", none,
     last, has_tree},
    {"step.to", "", "Go to step", "", "Goes to the step of this number, from 1.", Argument::words,
     go_to, has_tree},
    {"step.play",
     "Step",
     "Play",
     "Space",
     "Goes on by itself, or stops.",
     none,
     play,
     has_tree,
     plays,
     {},
     true},
    {"step.faster", "Step", "Faster", "Ctrl+.", "Plays faster.", none, change_pace<200>},
    {"step.slower", "Step", "Slower", "Ctrl+,", "Plays more slowly.", none, change_pace<50>},
    {"step.by_levels",
     "Step",
     "Level by level",
     "V",
     "Steps through whole levels: rays down the tree, then intensities up.",
     none,
     by_levels,
     has_tree,
     goes_by_levels,
     {},
     true},
};

}  // namespace

std::span<const Command> step_commands() { return table; }

}  // namespace raytree::inspector
