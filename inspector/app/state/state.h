#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "state/changes.h"
#include "state/document.h"
#include "state/edits.h"
#include "state/explained.h"
#include "state/explanation.h"
#include "state/history.h"
#include "state/lesson_run.h"
#include "state/look.h"
#include "state/newest_work.h"
#include "state/playback.h"
#include "state/table.h"
#include "state/thing.h"
#include "state/tree_question.h"
#include "trace/render.h"

/// What the inspector shows. Views read it and are told what has changed; commands change it.
namespace raytree::inspector {

class State {
  public:
    using Observer = std::function<void(const Changes&)>;

    /// Called after every change, in the order of observing, for as long as the state lives.
    void observe(Observer observer) { observers_.push_back(std::move(observer)); }

    /// Null until a scene is open.
    const std::shared_ptr<const Document>& document() const { return document_; }
    Pixel pixel() const { return pixel_; }
    /// Null where no scene is open, where the pixel's tree has no finite intensity, and as long as
    /// it is being traced.
    const std::shared_ptr<const PixelTree>& tree() const { return tree_; }
    /// There whenever a tree is.
    const TreeRay<double>* selected() const;
    const Look& look() const { return look_; }
    /// The thing that is selected besides the ray, if one is.
    const std::optional<Thing>& thing() const { return thing_; }
    const TreePane& tree_pane() const { return tree_pane_; }
    const Table& table() const { return table_; }
    const std::string& message() const { return message_; }

    /// Shows the scene and the pixel given, or else its most instructive one. The file's notes
    /// become the message.
    void show(const Opened& opened);
    /// Tells the views all that is shown, for views that have come later.
    void show_again();
    /// The open file, anew: what can stay as it is does, and what that cuts off the tree is shown
    /// as after a change.
    void renew(Opened opened);
    /// The scene's file, or that of a tree that was opened.
    const std::filesystem::path& opened_file() const { return opened_file_; }
    /// Chooses a pixel: of one outside the picture, the nearest in it.
    void pick(Pixel pixel, Pick how = Pick::apart);
    /// The pixels picked before and, after going back, those picked later.
    const History& history() const { return history_; }
    /// Chooses the pixel picked before, or later where `by` is 1; does nothing where there is none.
    void go_back(int by = -1);
    /// Selects a ray, and no thing any longer.
    void select(std::size_t ray);
    /// Selects a thing, the ray staying selected beneath it; none to have the ray alone.
    void select(std::optional<Thing> thing);
    void change_look(const std::function<void(Look&)>& change);
    void change_tree_pane(const TreePane& tree_pane);
    void change_table(const Table& table);
    void request(Request request, std::string text = {});
    /// Has the 3D view look from a place.
    void look_from(const lesson::FreeView& view);
    /// Whether a tree or an explanation is still to come: then `poll` is to be called now and then.
    bool working() const { return tracing_ || explaining(); }
    bool explaining() const { return explainer_->working(); }
    /// Takes what has come meanwhile, waiting for it no longer than `patience`.
    void poll(std::chrono::milliseconds patience = {});
    /// One line for people; empty to clear it.
    void say(std::string message);

    /// What takes longer than a window may stand still is done by whoever can do it beside the
    /// window, saying what is being done, and is done when that returns; here and now, unless there
    /// is somebody. Throws what the work throws.
    using Beside = std::function<void(const std::string& doing, const std::function<void()>& work)>;
    void set_beside(Beside beside) { beside_ = std::move(beside); }
    void do_beside(const std::string& doing, const std::function<void()>& work);
    /// Whether something is being done so: nothing is to be changed until it is done.
    bool busy() const { return busy_; }

    SidePane side_pane() const { return side_pane_; }
    void show_side(SidePane pane);

    // Stepping through the tree (state_steps.cpp).
    /// None unless the tree is being stepped through.
    const std::optional<Playback>& playback() const { return playback_; }
    StepOrder step_order() const { return step_order_; }
    bool playing() const { return playing_; }
    double pace() const { return pace_; }  ///< stops a second
    void start_stepping();
    void end_stepping();
    /// Selects the ray of which something happens there; starts stepping where that is not begun.
    void go_to_stop(std::size_t stop);
    /// How many there are; 0 without a tree.
    std::size_t stops() const;
    void set_step_order(StepOrder order);
    void play(bool playing);
    void set_pace(double stops_a_second);
    /// The next stop while playing; called at the pace.
    void tick();

    // Changing the scene (state_edits.cpp).
    const Edits& edits() const { return edits_; }
    /// Throws InputError where the value is none that a file may have; nothing has changed then.
    void change(const std::string& place, std::string_view text, Pick how = Pick::apart);
    void let_go() { edits_.let_go(); }
    void undo();
    void redo();
    void reset_values();
    /// Lets go of the branches that the last change cut off.
    void dismiss_cut();
    bool has_cut() const { return before_ && !against_; }
    /// Null: the scene came inside a tree's file or in a format that says less.
    const std::filesystem::path* own_file() const { return own_file_ ? &*own_file_ : nullptr; }
    /// Writes the scene; it is the open one's file from then on. Throws InputError.
    void save_scene_as(const std::filesystem::path& file);

    // Comparing trees (state_compare.cpp).
    /// Whether the shown tree is compared with another, or will be once it has come.
    bool comparing() const { return against_.has_value(); }
    /// Throws InputError where its pixel lies outside of the picture.
    void compare_with(std::shared_ptr<const check::Submission> recorded);
    /// From now on every pixel is compared with this one.
    void compare_with_pixel(Pixel pixel);
    std::optional<Pixel> compared_pixel() const;
    /// Before the last change and now.
    void compare_with_before();
    bool can_compare_with_before() const { return before_ != nullptr; }
    /// Shows the other of the two.
    /// Selects the ray of a line of the contrast, and remembers the line.
    void go_to_difference(std::size_t line);
    std::size_t difference() const { return difference_; }
    void swap_compared();
    void end_comparing();

    // Lessons (state_lesson.cpp).
    /// Null unless a lesson is open.
    const LessonRun* lesson() const { return lesson_.get(); }
    LessonSide lesson_side() const { return lesson_side_; }
    /// Where lessons are looked for; empty: where the program has its own.
    const std::filesystem::path& lesson_folder() const { return lesson_folder_; }
    void set_lesson_folder(std::filesystem::path folder) { lesson_folder_ = std::move(folder); }
    void show_lessons(LessonSide pane);
    void open_lesson(std::shared_ptr<const lesson::Lesson> lesson, std::size_t step = 0);
    void close_lesson();
    /// Steps from 0; does nothing for one that there is none of.
    void go_to_lesson_step(std::size_t step);
    /// Everything as the step shows it.
    void show_lesson_view();
    /// Throws InputError for an answer that cannot be judged.
    void give_answer(const Json& answer);
    void tell_answer();
    void ask_again();
    /// Shows the scene with the value that the question is about.
    void try_value(double value);
    /// The value that is shown of the member that the question is about.
    double value_tried() const;

    const Explained& explained() const { return explained_; }
    void explain(const std::function<void(Explained&)>& change);
    /// As much of it as has been worked out.
    const Explanation& explanation() const { return explainer_->explanation(); }

  private:
    void as_one_change(const std::function<void()>& work);
    void tell_gathered(Changes also);
    void stage(const lesson::Show& show);
    void step_up_to(std::size_t last);
    void prepare_lesson_step(std::size_t step);
    Explained explained_by(const lesson::Show& show) const;
    bool forget_measured();
    void show_answer(const Json& answer);
    void take_view(const lesson::View& view);
    void exchange(std::shared_ptr<const Document> document);
    void answer_by_pixel();
    void answer_by_ray();

    /// What will be shown as soon as its tree is there.
    struct Coming {
        std::shared_ptr<const Document> document;
        std::optional<Values> values;            ///< that it is to have first
        std::shared_ptr<const Document> before;  ///< of the change; null: nothing is left of it
        bool other_shapes = false;
    };

    void choose(Pixel pixel);
    Changes trace();
    void trace_again();
    std::optional<Changes> await_tree();
    void finish_tree();
    std::optional<Changes> take_tree(std::chrono::milliseconds patience);
    void take_coming(std::shared_ptr<const Document> document, Changes& changes);
    TreeQuestion question() const;
    void take_counterpart(std::size_t ray, const PixelTree* before);
    void say_whose();
    void install(Coming coming);
    Playback new_playback() const;
    void begin_playback();
    void tell(const Changes& changes);

    std::shared_ptr<const Document> document_;
    Pixel pixel_;
    History history_;
    std::shared_ptr<const PixelTree> tree_;
    std::size_t selected_ = 0;
    std::optional<Thing> thing_;
    bool tracing_ = false;
    using TreeWork = NewestWork<TracedPixel>;
    std::unique_ptr<TreeWork> tree_work_ = std::make_unique<TreeWork>();
    Look look_;
    TreePane tree_pane_;
    Table table_;
    std::string message_;
    std::string notes_;  ///< on the open file
    SidePane side_pane_ = SidePane::none;
    std::optional<Playback> playback_;
    StepOrder step_order_ = StepOrder::depth_first;
    bool playing_ = false;
    double pace_ = 2;
    Edits edits_;
    std::shared_ptr<const Document> before_;  ///< the last change, or before it was dismissed
    std::optional<Coming> coming_;
    std::filesystem::path opened_file_;
    std::optional<std::filesystem::path> own_file_;
    std::optional<Against> against_;
    std::size_t difference_ = ~std::size_t{0};  ///< the line that was gone to last
    std::optional<std::size_t> keep_selected_;  ///< in the tree before
    std::optional<std::size_t> same_selected_;  ///< the same tree is traced once more
    std::unique_ptr<LessonRun> lesson_;
    LessonSide lesson_side_ = LessonSide::hidden;
    std::filesystem::path lesson_folder_;
    /// While the views are set as a step wants them: what they are told of once all are.
    std::optional<Changes> gathered_;
    std::optional<double> tried_;  ///< instead of the step's own value
    Explained explained_;
    std::unique_ptr<Explainer> explainer_ = std::make_unique<Explainer>();
    Beside beside_;
    bool busy_ = false;
    std::vector<Observer> observers_;
};

/// Of a pixel's tree: what follows, leads to, or stands beside a ray.
std::optional<std::size_t> parent_of(const PixelTree& tree, std::size_t ray);
std::optional<std::size_t> first_child_of(const PixelTree& tree, std::size_t ray);
/// The place of a ray in the list of its parent's children, `by` further; none beyond its ends.
std::optional<std::size_t> sibling_of(const PixelTree& tree, std::size_t ray, int by);

/// Whether `ray` lies on the way to `selected` or is one of its children: what keeps its full
/// colour. Under the primary ray that is every ray.
bool belongs_to(const PixelTree& tree, std::size_t selected, std::size_t ray);

}  // namespace raytree::inspector
