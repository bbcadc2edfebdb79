#include "view3d/scene3d_parts.h"

#include <vtkActor.h>
#include <vtkBoundingBox.h>
#include <vtkCamera.h>
#include <vtkFloatArray.h>
#include <vtkLight.h>
#include <vtkPointData.h>
#include <vtkProperty.h>
#include <vtkShaderProperty.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <iterator>
#include <utility>

#include "drawing/coverage.h"
#include "view3d/picture_image.h"
#include "view3d/shape_shader.h"

namespace raytree::inspector {
namespace {

/// From how many triangles on only those shapes are drawn once more that may stand before a ray or
/// a mark.
constexpr std::size_t many_triangles = 20'000;

void set_background(vtkRenderer* renderer, const Palette& palette) {
    const auto& low = palette.space_bottom;
    const auto& high = palette.space_top;
    renderer->SetBackground(low.r / 255.0, low.g / 255.0, low.b / 255.0);
    renderer->SetBackground2(high.r / 255.0, high.g / 255.0, high.b / 255.0);
    renderer->GradientBackgroundOn();
}

/// Two lights that move along with the viewer: from the upper left, and weaker from the right.
void add_lights(vtkRenderer* renderer) {
    renderer->AutomaticLightCreationOff();
    struct Lamp {
        double x, y, z, intensity;
    };
    for (const Lamp& lamp : {Lamp{-0.6, 0.9, 1.0, 0.8}, Lamp{0.9, -0.2, 0.7, 0.3}}) {
        vtkNew<vtkLight> light;
        light->SetLightTypeToCameraLight();
        light->SetPosition(lamp.x, lamp.y, lamp.z);
        light->SetFocalPoint(0, 0, 0);
        light->SetIntensity(lamp.intensity);
        renderer->AddLight(light);
    }
}

}  // namespace

Scene3d::Parts::Parts() {
    window->SetOffScreenRendering(1);
    window->SwapBuffersOff();
    window->StencilCapableOn();
    window->SetMultiSamples(0);  // see-through shapes vanish with it
    window->AddRenderer(renderer);
    add_lights(renderer);
    set_shading();
    add_to_renderer();
    // Only the inner side of the halo is drawn: it shows around what it envelops, not over it.
    halo.actor->GetProperty()->FrontfaceCullingOn();
    smooth->InterpolateOn();
    picture.actor->GetProperty()->SetOpacity(0.85);  // rays behind it do not get lost
}

void Scene3d::Parts::add_to_renderer() {
    shapes_over.actor->SetProperty(shapes.actor->GetProperty());
    shapes_over.actor->SetShaderProperty(shapes.actor->GetShaderProperty());
    // In the order in which what is see-through is laid over each other.
    renderer->add_standing(shapes.actor, shapes_over.actor);
    renderer->add_standing(edges.actor, edges.actor);
    renderer->add_cover(picture.actor);
    for (Part* part : {&explained_faces, &explained_lines, &explained, &mark_lines, &marks,
                       &ray_lines, &rays, &halo, &fading, &angles, &faint_angles}) {
        renderer->AddActor(part->actor);
    }
    for (Part* part : {&picture, &edges, &mark_lines, &ray_lines, &fading, &faint_angles,
                       &explained_faces, &explained_lines}) {
        part->see_through(true);
    }
    for (Part* part : {&marks, &rays, &halo, &angles, &explained}) {
        part->see_through(false);
    }
}

void Scene3d::Parts::set_shading() {
    // Rays keep close to the colours of the legend; shapes are modelled by light.
    for (Part* part : {&rays, &fading, &marks, &explained}) {
        part->lit(0.72, 0.34);
    }
    shapes.lit(0.42, 0.68);
    for (Part* part : {&edges, &picture, &mark_lines, &ray_lines, &halo, &angles, &faint_angles,
                       &explained_faces, &explained_lines}) {
        part->unlit();
    }
}

void Scene3d::Parts::set_shape_shader() {
    vtkShaderProperty* const shader = shapes.actor->GetShaderProperty();
    shader->ClearAllFragmentShaderReplacements();
    shader->AddFragmentShaderReplacement(shape_shader_place, true,
                                         frame.style == ShapeStyle::solid
                                             ? solid_code()
                                             : see_through_code(palette_of(frame.theme).shape_line),
                                         false);
    if (frame.style == ShapeStyle::see_through) {
        // Where pixels may be discarded, software computes those too that the stencil hides.
        shader->AddFragmentShaderReplacement("discard;", true, "", true);
    }
}

void Scene3d::Parts::show_theme() {
    set_background(renderer, palette_of(frame.theme));
    renderer->forget_all();
}

void Scene3d::Parts::show_shapes() {
    const SceneMesh& mesh = *frame.shapes;
    const bool see_through = frame.style == ShapeStyle::see_through;
    shapes.set(mesh.faces);
    shapes.actor->SetVisibility(frame.style != ShapeStyle::wire && !mesh.faces.triangles.empty());
    shapes.see_through(see_through);
    shapes_over.see_through(see_through);
    shapes.actor->GetProperty()->SetOpacity(see_through ? palette_of(frame.theme).shape_strength
                                                        : 1);
    set_shape_shader();
    edges.set(frame.style == ShapeStyle::wire ? mesh.wires : mesh.edges);
    lay_over(nullptr);
    renderer->forget();
}

/// See-through shapes are drawn from back to front.
void Scene3d::Parts::sort_shapes() {
    if (frame.style == ShapeStyle::see_through) {
        const Point3& eye = frame.view.eye;
        order = drawing_order(*frame.shapes, frame.extent, eye);
        shapes.data->SetPolys(cells_of(triangles_of(*frame.shapes, order, eye), 3));
        lay_over(nullptr);
        renderer->forget();
    }
}

/// What is laid over rays: some of the shapes, or all where it is null.
void Scene3d::Parts::lay_over(const Mesh* some) {
    vtkActor* const actor = shapes_over.actor;
    actor->SetMapper(some ? shapes_over.mapper : shapes.mapper);
    if (some) {
        shapes_over.set(*some);
    }
    actor->SetVisibility(shapes.actor->GetVisibility() && (!some || !some->triangles.empty()));
}

/// Of many shapes only those are drawn once more that may stand before a ray or a mark.
void Scene3d::Parts::lay_shapes_over() {
    const SceneMesh& mesh = *frame.shapes;
    if (frame.style != ShapeStyle::see_through || mesh.faces.triangle_count() < many_triangles) {
        return;
    }
    const SceneThings& things = *frame.things;
    Coverage covered(frame.view);
    for (const Mesh* const thing : {&things.marks.solid, &things.rays.solid, &things.rays.halo,
                                    &things.angles.solid, &things.explained.solid}) {
        covered.add(*thing);
    }
    std::vector<std::size_t> over;
    std::ranges::copy_if(order, std::back_inserter(over), [&](std::size_t k) {
        return covered.is_behind(mesh.objects[k].centre, mesh.objects[k].radius);
    });
    if (over.size() < order.size() / 2) {
        const Mesh some = part_of(mesh, over, frame.view.eye);
        lay_over(&some);
    } else {
        lay_over(nullptr);
    }
}

void Scene3d::Parts::show_things() {
    const SceneThings& things = *frame.things;
    marks.set(things.marks.solid);
    mark_lines.set(things.marks.lines);
    rays.set(things.rays.solid);
    fading.set(things.rays.fading);
    halo.set(things.rays.halo);
    ray_lines.set(things.rays.lines);
    angles.set(things.angles.solid);
    faint_angles.set(things.angles.faint);
    explained_faces.set(things.explained.faces);
    explained_lines.set(things.explained.lines);
    explained.set(things.explained.solid);
}

void Scene3d::Parts::place_picture() {
    const PicturePlace& place = frame.picture_place;
    picture.actor->SetTexture(place.squares ? squares : smooth);
    vtkNew<vtkPoints> points;
    for (const Point3& corner : place.corners) {
        points->InsertNextPoint(corner.x, corner.y, corner.z);
    }
    picture.data->SetPoints(points);
    picture.data->SetPolys(cells_of({0, 1, 2, 3}, 4));
    picture.data->GetPointData()->SetTCoords(
        array_of<vtkFloatArray>(std::vector<float>{0, 0, 1, 0, 1, 1, 0, 1}, 2));
    picture.actor->SetVisibility(place.shown && frame.picture);
}

/// The picture from afar has about as many pixels as the screen gives it. OpenGL's mipmaps would do
/// so too, but software OpenGL takes 50 ms to compile what makes them.
void Scene3d::Parts::thin_picture() {
    if (!frame.picture) {
        return;
    }
    const ShownPicture& shown = *frame.picture;
    const auto& corners = frame.picture_place.corners;
    const double pixel = glm::length(corners[1] - corners[0]) / shown.width;
    const double seen = length_per_pixel(frame.view, (corners[0] + corners[2]) * 0.5) / pixel;
    int by = 1;
    while (2 * by <= std::min({seen, shown.width / 4.0, shown.height / 4.0})) {
        by *= 2;
    }
    if (std::exchange(thinned, by) != by) {
        const auto image = image_of(shown.width, shown.height, shown.cells, by);
        smooth->SetInputData(image);
        squares->SetInputData(image);
    }
}

void Scene3d::Parts::show_view() {
    const View& view = frame.view;
    vtkCamera* const camera = renderer->GetActiveCamera();
    const vtkMTimeType before = camera->GetMTime();
    camera->SetPosition(view.eye.x, view.eye.y, view.eye.z);
    camera->SetFocalPoint(view.target.x, view.target.y, view.target.z);
    const Point3 up = axes_of(view).up;
    camera->SetViewUp(up.x, up.y, up.z);
    camera->SetViewAngle(view.fov_degrees);
    cut_open();
    choose_depths(camera->GetMTime() == before);
}

void Scene3d::Parts::cut_open() {
    const View& view = frame.view;
    const Point3 forward = axes_of(view).forward, place = view.eye + forward * view.cut;
    cut->SetNormal(forward.x, forward.y, forward.z);
    cut->SetOrigin(place.x, place.y, place.z);
    for (Part* part : {&shapes, &edges}) {
        part->mapper->RemoveAllClippingPlanes();
        if (view.cut > 0) {
            part->mapper->AddClippingPlane(cut);
        }
    }
}

/// The depths between which things are drawn, rays included, with room for other rays: where only
/// these change, what stands still keeps its depths.
void Scene3d::Parts::choose_depths(bool same_view) {
    vtkBoundingBox box;
    double bounds[6];
    renderer->ComputeVisiblePropBounds(bounds);
    box.AddBounds(bounds);
    for (Part* part : {&shapes, &edges, &picture}) {
        if (part->actor->GetVisibility()) {
            box.AddBounds(part->actor->GetBounds());
        }
    }
    if (!box.IsValid()) {
        return;
    }
    box.GetBounds(bounds);
    vtkCamera* const camera = renderer->GetActiveCamera();
    const std::array<double, 2> old = depths;
    renderer->ResetCameraClippingRange(bounds);
    const double* const needed = camera->GetClippingRange();
    if (same_view && old[0] <= needed[0] && old[1] >= needed[1]) {
        camera->SetClippingRange(old[0], old[1]);
        return;
    }
    depths = {0.9 * needed[0], 1.2 * needed[1]};
    camera->SetClippingRange(depths[0], depths[1]);
    renderer->forget();
}

}  // namespace raytree::inspector
