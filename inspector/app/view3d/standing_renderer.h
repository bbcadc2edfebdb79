#pragma once

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkOpenGLFXAAFilter.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLRenderer.h>
#include <vtkSmartPointer.h>

#include <chrono>
#include <vector>

namespace raytree::inspector {

/// A renderer that keeps what it has drawn of things that stand still (shapes), as an image with
/// its depths, and draws into it what changes from pick to pick: rays and marks. See-through things
/// that stand before these are then laid over them once more, there alone, by the stencil: the
/// frame is the same as if all had been drawn in its order.
///
/// See-through things are laid over each other in the order in which they come.
///
/// Software takes long to draw many things. Frames show them roughly, with half as many rows and
/// columns, until the image that is kept has been drawn slice by slice between frames.
class StandingRenderer : public vtkOpenGLRenderer {
  public:
    static StandingRenderer* New();

    /// Things that stand still; they are not to be added as actors too. What `over` draws is laid
    /// over what changes: the thing itself, or as much of it as may stand there.
    void add_standing(vtkActor* actor, vtkActor* over);
    /// A see-through thing that is laid over these in every frame.
    void add_cover(vtkActor* actor);
    /// Something about what stands still, or the view, has changed: all is drawn in each frame,
    /// until `keep`.
    void forget() { keeps_ = kept_ = rough_is_there_ = false; }
    /// The background has changed.
    void forget_all() {
        forget();
        ground_is_there_ = false;
    }
    /// Nothing is likely to change about them soon: the next frame keeps them; of many, `draw_more`
    /// has to be called until it has.
    void keep() { keeps_ = true; }
    /// Whether that has been asked for.
    bool is_keeping() const { return keeps_; }
    /// Whether the last frame was drawn into what is kept.
    bool keeps() const { return kept_; }
    /// Whether the last frame showed them roughly.
    bool is_rough() const { return rough_; }
    /// Draws more of what is to be kept, for about so long, and returns whether it is complete: the
    /// next frame shows it. Between frames, with the window's context current.
    bool draw_more(std::chrono::milliseconds time);
    /// From how many triangles and lines on things are many.
    void set_many(vtkIdType many);
    /// Whether frames draw everything in one go, no matter how long that takes.
    void draw_at_once(bool yes) { at_once_ = yes; }

    void DeviceRenderOpaqueGeometry(vtkFrameBufferObjectBase* target) override;
    void DeviceRenderTranslucentPolygonalGeometry(vtkFrameBufferObjectBase* target) override;
    void ReleaseGraphicsResources(vtkWindow* window) override;

  protected:
    int UpdateGeometry(vtkFrameBufferObjectBase* target) override;

  private:
    using Actors = std::vector<vtkSmartPointer<vtkActor>>;
    /// Where drawing slice by slice has come to: solid things are drawn before see-through ones.
    struct Slice {
        bool see_through = false;
        std::size_t actor = 0;
        vtkIdType first = 0;
    };

    vtkOpenGLRenderWindow* gl() const;
    void make_room();
    void set_viewport(int width, int height);
    bool has_depths() const;
    void clear_depths();
    void copy(vtkOpenGLFramebufferObject* from, vtkOpenGLFramebufferObject* to);
    std::size_t count_of_rough() const;
    void draw_roughly(std::size_t count);
    bool draw_slice();
    void draw_changes(vtkFrameBufferObjectBase* target);

    Actors standing_, cover_, over_;
    vtkNew<vtkOpenGLFramebufferObject> image_;  ///< what is kept, or is being drawn slice by slice
    vtkNew<vtkOpenGLFramebufferObject> rough_image_;
    vtkNew<vtkOpenGLFramebufferObject> ground_;  ///< the background alone
    vtkNew<vtkOpenGLFXAAFilter> smooth_;
    Slice slice_;
    vtkIdType many_ = 20'000;
    int width_ = 0, height_ = 0;  ///< of image_
    bool keeps_ = false, kept_ = false;
    bool rough_ = false, rough_is_there_ = false, ground_is_there_ = false, at_once_ = false;
};

}  // namespace raytree::inspector
