#include "state/state.h"

#include <algorithm>
#include <utility>

#include "state/start_pixel.h"

namespace raytree::inspector {
namespace {

/// As one change, of which the last request counts.
void add(Changes& all, const Changes& more) {
    for (bool Changes::*const what :
         {&Changes::document, &Changes::tree, &Changes::selection, &Changes::look,
          &Changes::tree_pane, &Changes::table, &Changes::message, &Changes::values,
          &Changes::coats, &Changes::playback, &Changes::side_pane, &Changes::lesson,
          &Changes::explained}) {
        all.*what = all.*what || more.*what;
    }
    if (more.view_from) {
        all.view_from = more.view_from;
    }
    if (more.request) {
        all.request = more.request;
        all.text = more.text;
    }
}

}  // namespace

const TreeRay<double>* State::selected() const {
    return tree_ ? &tree_->tree.rays[selected_] : nullptr;
}

void State::show(const Opened& opened) {
    document_ = opened.document;
    edits_.begin(values_of(document_->scene()));
    before_.reset();
    coming_.reset();
    against_.reset();
    keep_selected_.reset();
    playing_ = false;
    playback_.reset();
    opened_file_ =
        opened.recorded ? std::filesystem::path(opened.recorded->file) : document_->file();
    const bool can_save = !opened.scene_inside && document_->file().extension() == ".json";
    own_file_ = can_save ? std::optional(document_->file()) : std::nullopt;
    pixel_ = opened.pixel ? *opened.pixel : start_pixel(*document_);
    history_.begin(pixel_);
    if (thing_ && !exists(document_->scene(), *thing_)) {
        thing_.reset();
    }
    notes_.clear();
    for (const std::string& note : opened.notes) {
        notes_ += (notes_.empty() ? "" : "  ") + note;
    }
    message_ = notes_;
    forget_measured();
    if (opened.recorded) {
        against_ = Against{Contrast::What::file, pixel_, nullptr, opened.recorded, false};
        side_pane_ = SidePane::compare;
    }
    trace();
    tell({.document = true,
          .tree = true,
          .selection = true,
          .message = true,
          .playback = true,
          .side_pane = true});
}

void State::show_again() {
    tell({.document = document_ != nullptr,
          .tree = true,
          .selection = true,
          .look = true,
          .tree_pane = true,
          .message = true,
          .playback = true,
          .side_pane = true,
          .lesson = true,
          .explained = true});
}

void State::renew(Opened opened) {
    const bool fits = opened.document->contains(pixel_);
    if (opened.recorded || against_ || !fits) {
        if (fits && !opened.recorded) {
            opened.pixel = pixel_;
        }
        show(opened);
        return;
    }
    edits_.begin(values_of(opened.document->scene()));
    install({opened.document, std::nullopt, document_, true});
}

void State::pick(Pixel pixel, Pick how) {
    if (!document_) {
        return;
    }
    const Camera& camera = document_->scene().camera;
    pixel = {std::clamp(pixel.i, 0, camera.width - 1), std::clamp(pixel.j, 0, camera.height - 1)};
    if (pixel == pixel_ && tree_) {
        answer_by_pixel();
        return;
    }
    if (pixel != pixel_) {
        history_.add(pixel, how);
    }
    choose(pixel);
    answer_by_pixel();
}

void State::go_back(int by) {
    if (const auto pixel = history_.at(by)) {
        history_.go(by);
        choose(*pixel);
    }
}

void State::choose(Pixel pixel) {
    pixel_ = pixel;
    keep_selected_.reset();
    same_selected_.reset();
    trace_again();
}

/// The tree before is no longer shown.
Changes State::trace() {
    tree_.reset();
    selected_ = 0;
    Changes changes = await_tree().value_or(Changes{});
    changes.tree = changes.selection = changes.message = true;
    return changes;
}

/// A tree that takes no longer than a glance is waited for.
std::optional<Changes> State::await_tree() {
    constexpr std::chrono::milliseconds glance(30);
    tracing_ = true;
    tree_work_->ask(
        [asked = question()](const std::stop_token& stop) { return answer(asked, stop); });
    auto changes = take_tree(glance);
    if (!changes) {
        message_ = tree_ ? "Working out what is shown next…"
                         : "Tracing the tree of pixel " + text_of(pixel_) + "…";
    }
    return changes;
}

/// However long that takes: beside the window, whose views show meanwhile that a tree is to come.
void State::finish_tree() {
    if (!tracing_) {
        return;
    }
    if (gathered_) {
        tell_gathered({.message = true});
        gathered_.emplace();
    }
    do_beside("Tracing the tree of pixel " + text_of(pixel_), [this] { tree_work_->wait(); });
    poll();
}

TreeQuestion State::question() const {
    return {coming_ ? coming_->document : document_,
            coming_ ? coming_->values : std::nullopt,
            pixel_,
            look_.bounds,
            look_.neighbours,
            coming_ ? coming_->before : before_,
            against_};
}

void State::trace_again() {
    message_.clear();
    Changes changes = trace();
    changes.playback = changes.playback || playback_.has_value();
    tell(changes);
}

std::optional<Changes> State::take_tree(std::chrono::milliseconds patience) {
    auto traced = tree_work_->take(patience);
    if (!traced) {
        return std::nullopt;
    }
    Changes changes{.tree = true, .selection = true, .message = true};
    tracing_ = false;
    const auto before = std::exchange(tree_, std::move(traced->tree));
    selected_ = 0;
    if (!traced->failure.empty()) {
        message_ = traced->failure;
    }
    if (coming_) {
        take_coming(std::move(traced->document), changes);
    }
    const auto same = std::exchange(same_selected_, std::nullopt);
    if (tree_) {
        if (same && *same < tree_->tree.rays.size()) {
            selected_ = *same;
        }
        if (keep_selected_) {
            take_counterpart(*keep_selected_, before.get());
        }
        if (playback_) {
            begin_playback();
            changes.playback = true;
        }
        say_whose();
    }
    return changes;
}

void State::do_beside(const std::string& doing, const std::function<void()>& work) {
    if (!beside_ || busy_) {
        return work();
    }
    struct Busy {
        bool& flag;
        explicit Busy(bool& f) : flag(f) { flag = true; }
        ~Busy() { flag = false; }
    } const busy(busy_);
    beside_(doing, work);
}

void State::poll(std::chrono::milliseconds patience) {
    if (busy_) {
        return;
    }
    if (tracing_) {
        const std::string waiting = std::exchange(message_, {});
        if (const auto changes = take_tree(patience)) {
            tell(*changes);
        } else {
            message_ = waiting;
        }
    }
    if (explainer_->poll(patience)) {
        message_ += explainer_->explanation().failure;
        tell({.message = !explainer_->explanation().failure.empty(), .explained = true});
    }
}

void State::select(std::size_t ray) {
    if (!tree_ || ray >= tree_->tree.rays.size()) {
        return;
    }
    if (ray != selected_ || thing_) {
        selected_ = ray;
        thing_.reset();
        tell({.selection = true});
    }
    answer_by_ray();
}

void State::select(std::optional<Thing> thing) {
    if (document_ && thing_ != thing && (!thing || exists(document_->scene(), *thing))) {
        thing_ = thing;
        tell({.selection = true});
    }
}

void State::change_look(const std::function<void(Look&)>& change) {
    const bool bounds = look_.bounds;
    const Neighbours neighbours = look_.neighbours;
    change(look_);
    Changes changes;
    if (document_ && (bounds != look_.bounds || neighbours != look_.neighbours)) {
        same_selected_ = selected_;
        changes = await_tree().value_or(Changes{.message = true});
    }
    changes.look = true;
    tell(changes);
}

void State::request(Request request, std::string text) {
    tell({.request = request, .text = std::move(text)});
}

void State::change_table(const Table& table) {
    table_ = table;
    tell({.table = true});
}

void State::look_from(const lesson::FreeView& view) { tell({.view_from = view}); }

void State::change_tree_pane(const TreePane& tree_pane) {
    tree_pane_ = tree_pane;
    tell({.tree_pane = true});
}

void State::say(std::string message) {
    message_ = std::move(message);
    tell({.message = true});
}

void State::show_side(SidePane pane) {
    if (pane != side_pane_) {
        side_pane_ = pane;
        tell({.side_pane = true});
    }
}

/// What the work changes is one change for the views, and answers no question of a lesson.
void State::as_one_change(const std::function<void()>& work) {
    gathered_.emplace();
    try {
        work();
    } catch (...) {  // or no view would be told of anything any more
        tell_gathered({.message = true});
        throw;
    }
    tell_gathered({.message = true, .lesson = true});
}

void State::tell_gathered(Changes also) {
    add(also, std::exchange(gathered_, std::nullopt).value_or(Changes{}));
    tell(also);
}

void State::tell(const Changes& changes) {
    if (changes.document || changes.tree || changes.selection || changes.values ||
        changes.explained) {
        explainer_->ask({document_, tree_, pixel_, selected_, explained_});
    }
    if (gathered_) {
        add(*gathered_, changes);
        return;
    }
    for (const Observer& observer : observers_) {
        observer(changes);
    }
}

std::optional<std::size_t> parent_of(const PixelTree& tree, std::size_t ray) {
    return tree.tree.rays[ray].parent;
}

std::optional<std::size_t> first_child_of(const PixelTree& tree, std::size_t ray) {
    const auto& children = tree.children[ray];
    return children.empty() ? std::nullopt : std::optional(children.front());
}

std::optional<std::size_t> sibling_of(const PixelTree& tree, std::size_t ray, int by) {
    const auto parent = parent_of(tree, ray);
    if (!parent) {
        return std::nullopt;
    }
    const auto& all = tree.children[*parent];
    const auto place = std::ranges::find(all, ray) - all.begin() + by;
    if (place < 0 || place >= static_cast<std::ptrdiff_t>(all.size())) {
        return std::nullopt;
    }
    return all[static_cast<std::size_t>(place)];
}

bool belongs_to(const PixelTree& tree, std::size_t selected, std::size_t ray) {
    if (selected == 0 || ray == selected || parent_of(tree, ray) == selected) {
        return true;
    }
    for (auto up = parent_of(tree, selected); up; up = parent_of(tree, *up)) {
        if (*up == ray) {
            return true;
        }
    }
    return false;
}

}  // namespace raytree::inspector
