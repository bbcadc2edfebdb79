#include "lesson/play.h"

#include <cmath>

#include "tree/explain.h"

namespace raytree::lesson {
namespace {

const Ask& ask_of(const Step& step) {
    if (!step.ask) {
        throw ExpressionError("the step asks nothing");
    }
    return *step.ask;
}

double number_in(const Json& answer) {
    if (!answer.is_number()) {
        throw ExpressionError("found " + shown(answer) + ", where a number is wanted");
    }
    return answer.get<double>();
}

std::size_t place_in(const Json& answer, std::size_t count) {
    const double number = number_in(answer);
    if (!(number >= 0) || !(number < static_cast<double>(count)) || std::floor(number) != number) {
        throw ExpressionError("found " + answer.dump() + ", must be a whole number from 0 to " +
                              std::to_string(count - 1));
    }
    return static_cast<std::size_t>(number);
}

Pixel pixel_in(const Json& answer, const Camera& camera) {
    if (!answer.is_array() || answer.size() != 2) {
        throw ExpressionError("found " + answer.dump() + ", must be a column and a row");
    }
    return {static_cast<int>(place_in(answer[0], static_cast<std::size_t>(camera.width))),
            static_cast<int>(place_in(answer[1], static_cast<std::size_t>(camera.height)))};
}

constexpr double option_tolerance = 1e-9;  // of an option's value that is a number

std::string ray_text(const TreeRay<double>& ray) {
    return "#" + std::to_string(ray.id) + ", the " + std::string(word_of(ray.kind)) + " ray" +
           (ray.shadow ? " to " + ray.shadow->light : "");
}

}  // namespace

Play::Play(std::shared_ptr<const Lesson> lesson, TreeSource trace)
    : lesson_(std::move(lesson)), trace_(std::move(trace)) {}

std::shared_ptr<const StageWorld> Play::world(std::size_t step) const {
    const Show& show = this->step(step).show;
    auto& world = worlds_[{show.scene, show.change.dump()}];
    if (!world) {
        world = std::make_shared<const StageWorld>(
            stage_scene(lesson_->file.parent_path() / show.scene, show.change), trace_);
    }
    return world;
}

std::size_t Play::ray(std::size_t step) const {
    const Show& show = this->step(step).show;
    if (show.ray.empty()) {
        return 0;
    }
    const std::size_t count = world(step)->tree_at(show.pixel.i, show.pixel.j)->rays.size();
    return place_in(show.ray.data(*scope(step)), count);
}

std::shared_ptr<const Scope> Play::scope(std::size_t step) const {
    const auto find = [this](std::size_t from_one) {
        return from_one >= 1 && from_one <= lesson_->steps.size() ? scope(from_one - 1) : nullptr;
    };
    return pixel_scope(world(step), this->step(step).show, find);
}

FilledText Play::text(std::size_t step) const { return fill(this->step(step).text, *scope(step)); }

FilledText Play::question(std::size_t step) const {
    return fill(ask_of(this->step(step)).question, *scope(step));
}

FilledText Play::option(std::size_t step, std::size_t option) const {
    return fill(ask_of(this->step(step)).options.at(option).text, *scope(step));
}

/// What `truth` and `when` see: the step, with the answer.
std::shared_ptr<const Scope> Play::scope_of(std::size_t step, const Json& answer) const {
    const Ask& ask = ask_of(this->step(step));
    const Show& show = this->step(step).show;
    const auto here = scope(step);
    switch (ask.kind) {
        case AskKind::choice:
            return extended(
                here,
                {{"answer", Value::of(ask.options[place_in(answer, ask.options.size())].value)}});
        case AskKind::pixel: {
            Show there = show;
            there.pixel = pixel_in(answer, world(step)->scene().camera);
            there.ray = Expression();
            return extended(here,
                            {{"picked", Value{nullptr, pixel_scope(world(step), there, {})}}});
        }
        case AskKind::ray: {
            const auto tree = world(step)->tree_at(show.pixel.i, show.pixel.j);
            const std::size_t ray = place_in(answer, tree->rays.size());
            return extended(here,
                            {{"picked", Value{nullptr, ray_scope(world(step), show.pixel, ray)}}});
        }
        case AskKind::value: {
            const auto staged =
                change_scene(world(step)->staged(), ask.set.to_string(), number_in(answer));
            const auto changed = std::make_shared<const StageWorld>(staged, trace_);
            Show plain = show;
            plain.ray = Expression();
            return extended(pixel_scope(changed, plain, {}), {{"answer", Value::of(answer)}});
        }
        default:
            return extended(here, {{"answer", Value::of(number_in(answer))}});
    }
}

bool Play::is_right(std::size_t step, const Json& answer) const {
    const Ask& ask = ask_of(this->step(step));
    if (ask.kind == AskKind::number) {
        return std::abs(number_in(answer) - ask.truth.number(*scope(step))) <= ask.tolerance;
    }
    if (ask.kind == AskKind::choice) {
        const Json& chosen = ask.options[place_in(answer, ask.options.size())].value;
        return same(ask.truth.data(*scope(step)), chosen, option_tolerance);
    }
    return ask.truth.truth(*scope_of(step, answer));
}

bool Play::is_answer_of_mistake(std::size_t step, const std::string& mistake,
                                const Json& answer) const {
    const Ask& ask = ask_of(this->step(step));
    const Json given = ask.kind == AskKind::choice
                           ? ask.options[place_in(answer, ask.options.size())].value
                           : answer;
    try {
        const Value word = Value::of(mistake);
        const auto wrong = scope(step)->call("mistake", std::span(&word, 1));
        return same(ask.truth.data(*wrong->scope), given,
                    std::max(ask.tolerance, option_tolerance));
    } catch (const ExpressionError&) {
        return false;  // what is asked for does not exist with this mistake
    } catch (const InputError&) {
        return false;
    }
}

const Text* Play::hint_for(std::size_t step, const Json& answer) const {
    const Ask& ask = ask_of(this->step(step));
    for (const Hint& hint : ask.hints) {
        if (!hint.when.empty()) {
            if (hint.when.truth(*scope_of(step, answer))) {
                return &hint.text;
            }
            continue;
        }
        if (is_answer_of_mistake(step, hint.mistake, answer)) {
            return &hint.text;
        }
    }
    if (ask.kind == AskKind::choice) {
        const Option& option = ask.options[place_in(answer, ask.options.size())];
        return option.hint.empty() ? nullptr : &option.hint;
    }
    return nullptr;
}

Json Play::right_answer(std::size_t step) const {
    const Ask& ask = ask_of(this->step(step));
    if (ask.kind == AskKind::number) {
        return ask.truth.data(*scope(step));
    }
    if (ask.kind == AskKind::pixel || ask.kind == AskKind::value) {
        return ask.example;
    }
    const Show& show = this->step(step).show;
    const std::size_t count = ask.kind == AskKind::choice
                                  ? ask.options.size()
                                  : world(step)->tree_at(show.pixel.i, show.pixel.j)->rays.size();
    for (std::size_t k = 0; k < count; ++k) {
        if (is_right(step, k)) {
            return k;
        }
    }
    throw ExpressionError("no answer is right: " + ask.truth.text());
}

std::string Play::truth_text(std::size_t step) const {
    const Ask& ask = ask_of(this->step(step));
    const Json right = right_answer(step);
    const Show& show = this->step(step).show;
    switch (ask.kind) {
        case AskKind::choice:
            return plain_text(option(step, right.get<std::size_t>()));
        case AskKind::pixel:
            return "such as pixel " + value_text(right);
        case AskKind::ray:
            return ray_text(
                world(step)->tree_at(show.pixel.i, show.pixel.j)->rays[right.get<std::size_t>()]);
        case AskKind::value:
            return "such as " + value_text(right) + ask.unit;
        default:
            return value_text(right) + ask.unit;
    }
}

Judgement Play::judge(std::size_t step, const Json& answer) const {
    Judgement judgement;
    const auto here = scope(step);
    judgement.right = is_right(step, answer);
    judgement.truth = truth_text(step);
    if (!judgement.right) {
        if (const Text* const hint = hint_for(step, answer)) {
            judgement.hint = fill(*hint, *here);
        }
    }
    judgement.after = fill(ask_of(this->step(step)).after, *here);
    return judgement;
}

}  // namespace raytree::lesson
