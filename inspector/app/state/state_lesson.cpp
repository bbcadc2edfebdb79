#include "state/state.h"

#include <utility>

namespace raytree::inspector {
namespace {

using lesson::AskKind;
using lesson::NamedView;

Request request_of(NamedView view) {
    switch (view) {
        case NamedView::camera:
            return Request::through_camera;
        case NamedView::side:
            return Request::from_side;
        case NamedView::tree:
            return Request::fit_tree;
        default:
            return Request::fit_selection;
    }
}

ShapeStyle style_of(lesson::ShapeLook look) {
    switch (look) {
        case lesson::ShapeLook::solid:
            return ShapeStyle::solid;
        case lesson::ShapeLook::wire:
            return ShapeStyle::wire;
        default:
            return ShapeStyle::see_through;
    }
}

void take_look(Look& look, const lesson::Show& show) {
    look.shapes = style_of(show.shapes);
    look.overlay = show.overlay;
    look.depth_overlay = show.depth_overlay;
    look.filter = {};
    look.angles = !show.hide_angles;
    look.ghosts = !show.hide_unsent;
    for (const RayKind kind : show.hide) {
        look.filter.set(group_of(kind), Shown::hidden);
    }
}

/// The tab of the tree's pane that a step wants in front.
TreePane::Tab tab_of(const lesson::Show& show) {
    if (show.panel == lesson::Panel::diagram) {
        return TreePane::Tab::diagram;
    }
    if (show.panel == lesson::Panel::counts) {
        return TreePane::Tab::counts;
    }
    if (show.panel == lesson::Panel::outline) {
        return TreePane::Tab::outline;
    }
    if (show.panel == lesson::Panel::explained) {
        return TreePane::Tab::explained;
    }
    const bool explains = show.z_buffer || show.shower || show.traversal || show.volumes ||
                          show.depth || show.crossings || show.time || show.accuracy;
    if (explains) {
        return TreePane::Tab::explained;
    }
    return TreePane::Tab::outline;
}

}  // namespace

void State::show_lessons(LessonSide pane) {
    lesson_side_ = pane == LessonSide::lesson && !lesson_ ? LessonSide::contents : pane;
    tell({.lesson = true});
}

void State::open_lesson(std::shared_ptr<const lesson::Lesson> lesson, std::size_t step) {
    lesson_ = std::make_unique<LessonRun>(std::move(lesson));
    lesson_side_ = LessonSide::lesson;
    go_to_lesson_step(step < lesson_->count() ? step : 0);
}

void State::close_lesson() {
    lesson_.reset();
    lesson_side_ = LessonSide::hidden;
    explain([](Explained& explained) { explained = {}; });
    tell({.lesson = true});
}

void State::go_to_lesson_step(std::size_t step) {
    if (lesson_ && step < lesson_->count()) {
        prepare_lesson_step(step);
        lesson_side_ = LessonSide::lesson;
        show_lesson_view();
    }
}

void State::prepare_lesson_step(std::size_t step) {
    LessonPage page;
    do_beside("Measuring what the step tells", [&] { page = lesson_->prepared(step); });
    lesson_->go_to(step, std::move(page));
}

void State::show_lesson_view() {
    if (!lesson_) {
        return;
    }
    const lesson::Show& show = lesson_->here().show;
    tried_.reset();
    as_one_change([&] {
        try {
            stage(show);
        } catch (const InputError& error) {
            message_ = error.what();
        }
    });
}

/// What is measured is what the step's text says of it.
Explained State::explained_by(const lesson::Show& show) const {
    return {show.eye_space,
            show.z_buffer,
            show.shower,
            show.traversal,
            show.volumes,
            show.depth,
            show.crossings,
            show.time ? std::optional(lesson_->time_share()) : std::nullopt,
            show.accuracy ? std::optional(lesson_->work_precision()) : std::nullopt};
}

/// It was measured of another scene. Whether there was something.
bool State::forget_measured() {
    const bool measured = explained_.time || explained_.accuracy;
    explained_.time.reset();
    explained_.accuracy.reset();
    return measured;
}

/// The views as the step wants them.
void State::stage(const lesson::Show& show) {
    const auto document = lesson_->document();
    const Pixel pixel{show.pixel.i, show.pixel.j};
    explained_ = {};  // what the step before showed is not worked out for this one
    if (document_ != document || coming_) {
        this->show({.document = document, .pixel = pixel, .notes = {}});
        own_file_.reset();  // it is the lesson's: changes of it are saved elsewhere
    } else {
        pick(pixel);
    }
    finish_tree();
    if (show.stepped && tree_) {
        step_up_to(static_cast<std::size_t>(*show.stepped));
    } else {
        end_stepping();
    }
    select(lesson_->ray());
    change_look([&](Look& look) { take_look(look, show); });
    explain([&](Explained& explained) { explained = explained_by(show); });
    TreePane pane = tree_pane_;
    pane.tab = tab_of(show);
    change_tree_pane(pane);
    take_view(show.view);
}

/// As far as the tree can be stepped without a ray after `last`.
void State::step_up_to(std::size_t last) {
    begin_playback();
    playback_->go_to(playback_->stops());
    while (playback_->stop() > 0 && last + 1 < tree_->tree.rays.size() &&
           playback_->stage(last + 1) != Stage::unsent) {
        playback_->go_to(playback_->stop() - 1);
    }
    tell({.selection = true, .playback = true});
}

void State::take_view(const lesson::View& view) {
    if (const auto* named = std::get_if<NamedView>(&view)) {
        request(request_of(*named));
    } else {
        look_from(std::get<lesson::FreeView>(view));
    }
}

void State::give_answer(const Json& answer) {
    if (lesson_) {
        lesson_->give(answer);
        if (lesson_->here().ask->kind == AskKind::value) {
            try_value(answer.get<double>());
        }
        tell({.lesson = true});
    }
}

void State::tell_answer() {
    if (!lesson_ || !lesson_->here().ask) {
        return;
    }
    lesson_->tell();
    as_one_change([&] { show_answer(lesson_->right_answer()); });
}

/// What a click or the slider would do.
void State::show_answer(const Json& answer) {
    switch (lesson_->here().ask->kind) {
        case AskKind::pixel:
            return pick({answer[0].get<int>(), answer[1].get<int>()});
        case AskKind::ray:
            return select(answer.get<std::size_t>());
        case AskKind::value:
            return try_value(answer.get<double>());
        default:
            return;
    }
}

void State::ask_again() {
    if (lesson_) {
        lesson_->forget_answer();
        tell({.lesson = true});
    }
}

void State::try_value(double value) {
    if (!busy_ && lesson_ && lesson_->here().ask && lesson_->here().ask->kind == AskKind::value) {
        if (value != value_tried()) {
            const auto document = lesson_->document_with(value);
            tried_ = value;  // before views are told of the scene: they ask for it
            exchange(document);
        }
    }
}

double State::value_tried() const { return tried_.value_or(lesson_->value_shown()); }

/// Another document in the place of this one, seen in the same way: the same ray stays selected.
void State::exchange(std::shared_ptr<const Document> document) {
    edits_.begin(values_of(document->scene()));
    install({std::move(document), std::nullopt, nullptr, true});
}

void State::explain(const std::function<void(Explained&)>& change) {
    change(explained_);
    tell({.explained = true});
}

void State::answer_by_pixel() {
    const bool asked = lesson_ && !gathered_ && lesson_->here().ask &&
                       lesson_->here().ask->kind == AskKind::pixel &&
                       document_ == lesson_->document();
    if (asked) {
        give_answer(Json::array({pixel_.i, pixel_.j}));
    }
}

void State::answer_by_ray() {
    if (!lesson_ || gathered_ || !lesson_->here().ask ||
        lesson_->here().ask->kind != AskKind::ray) {
        return;
    }
    const lesson::Pixel asked = lesson_->here().show.pixel;
    if (document_ == lesson_->document() && pixel_ == Pixel{asked.i, asked.j}) {
        give_answer(selected_);
    }
}

}  // namespace raytree::inspector
