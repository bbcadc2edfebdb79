#include "window/change_pane.h"

#include <QCheckBox>
#include <QComboBox>
#include <QEvent>
#include <QFormLayout>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QSlider>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <utility>

#include "state/commands.h"
#include "window/qt_text.h"

namespace raytree::inspector {
namespace {

constexpr int slider_steps = 1000;

/// A knob's value as a place on its slider, and back.
int place_of(const Knob& knob, double value) {
    if (knob.kind == Knob::Kind::whole) {
        return static_cast<int>(std::clamp(value, knob.least, knob.most));
    }
    double share = (value - knob.least) / (knob.most - knob.least);
    if (knob.logarithmic) {
        share = value <= 0 ? 0 : std::log(value / knob.least) / std::log(knob.most / knob.least);
    }
    return static_cast<int>(std::lround(slider_steps * std::clamp(share, 0.0, 1.0)));
}
double value_at(const Knob& knob, int place) {
    if (knob.kind == Knob::Kind::whole) {
        return place;
    }
    const double share = static_cast<double>(place) / slider_steps;
    if (knob.logarithmic) {
        return place == 0 ? 0 : knob.least * std::pow(knob.most / knob.least, share);
    }
    return knob.least + share * (knob.most - knob.least);
}

/// Whether they look and work alike.
bool same_row(const Knob& a, const Knob& b) {
    return a.place == b.place && a.label == b.label && a.kind == b.kind && a.least == b.least &&
           a.most == b.most && a.logarithmic == b.logarithmic && a.words == b.words;
}

/// The numbers with fewer digits, where all of them have no room.
QString in_room(const QString& text, const QFontMetrics& metrics, int room) {
    QString brief = text;
    for (int digits = 6; digits > 1 && metrics.horizontalAdvance(brief) > room; --digits) {
        QStringList parts = text.split(QStringLiteral(", "));
        for (QString& part : parts) {
            bool is_number = false;
            const double number = part.toDouble(&is_number);
            part = is_number ? QString::number(number, 'g', digits) : part;
        }
        brief = parts.join(QStringLiteral(", "));
    }
    return brief;
}

/// The object that the ray hits, or the light that it asks.
std::optional<KnobOwner> owner_of(const Scene& scene, const TreeRay<double>& ray) {
    if (ray.shadow) {
        const auto light = std::ranges::find(scene.lights, ray.shadow->light, &Light::name);
        return light == scene.lights.end()
                   ? std::nullopt
                   : std::optional(
                         KnobOwner{KnobOwner::Kind::light,
                                   static_cast<std::size_t>(light - scene.lights.begin())});
    }
    if (!ray.hit) {
        return std::nullopt;
    }
    const std::string name = ray.hit->object.substr(0, ray.hit->object.find('#'));
    const auto object = std::ranges::find_if(scene.objects, [&](const Object& one) {
        return one.name == ray.hit->object || one.name == name;
    });
    return object == scene.objects.end()
               ? std::nullopt
               : std::optional(KnobOwner{KnobOwner::Kind::material, object->material});
}

/// The light itself, or what the object is made of.
KnobOwner owner_of(const Scene& scene, Thing thing) {
    return thing.kind == Thing::Kind::light
               ? KnobOwner{KnobOwner::Kind::light, thing.index}
               : KnobOwner{KnobOwner::Kind::material, scene.objects[thing.index].material};
}

}  // namespace

ChangePane::ChangePane(State& state, std::function<void(const std::string& command)> run,
                       std::function<void(const InputError&)> fail, QWidget* parent)
    : QWidget(parent), state_(state), run_(std::move(run)), fail_(std::move(fail)) {
    owners_ = new QComboBox;
    owners_->setAccessibleName(QStringLiteral("What is changed"));
    owners_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    owners_->setMinimumContentsLength(12);
    follows_ = new QCheckBox(QStringLiteral("Follow rays as they are selected"));
    follows_->setToolTip(
        QStringLiteral("Goes to the material that the ray hits, or to the light that it asks"));
    follows_->setChecked(true);
    area_ = new QScrollArea;
    area_->setWidgetResizable(true);
    area_->setFrameShape(QFrame::NoFrame);
    area_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto* const layout = new QVBoxLayout(this);
    layout->setContentsMargins(6, 6, 6, 6);
    layout->addWidget(owners_);
    layout->addWidget(follows_);
    layout->addWidget(area_, 1);
    layout->addWidget(make_buttons());
    connect(owners_, qOverload<int>(&QComboBox::currentIndexChanged), this,
            [this] { show_owner(); });
    connect(follows_, &QCheckBox::toggled, this, [this] { follow_ray(); });
    state_.observe([this](const Changes& changes) { obey(changes); });
}

QWidget* ChangePane::make_buttons() {
    auto* const box = new QWidget;
    auto* const layout = new QGridLayout(box);  // beside a lesson there is no room for one row
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    constexpr int row_length = 3;
    for (const auto& [command, title] :
         {std::pair("change.undo", "Undo"), std::pair("change.redo", "Redo"),
          std::pair("change.reset", "Reset"), std::pair("compare.before", "Compare"),
          std::pair("file.save", "Save")}) {
        auto* const made = new QPushButton(QString::fromUtf8(title));
        made->setToolTip(qt(find_command(command)->help));
        const int place = static_cast<int>(buttons_.size());
        layout->addWidget(made, place / row_length, place % row_length);
        buttons_.emplace_back(made, command);
        connect(made, &QPushButton::clicked, this, [this, id = command] { run_(id); });
    }
    return box;
}

QSlider* ChangePane::slider(const std::string& place) const {
    const auto row =
        std::ranges::find_if(rows_, [&](const Row& one) { return one.knob.place == place; });
    return row == rows_.end() ? nullptr : row->slider;
}

QLineEdit* ChangePane::field(const std::string& place) const {
    const auto row =
        std::ranges::find_if(rows_, [&](const Row& one) { return one.knob.place == place; });
    return row == rows_.end() ? nullptr : row->field;
}

void ChangePane::obey(const Changes& changes) {
    stale_list_ |= changes.document;
    stale_values_ |= changes.values;
    // With another tree, whoever looks at the settings goes on doing so.
    const bool on_settings = stale_list_ || owners_->currentIndex() <= 0;
    stale_ray_ |= changes.selection && !changes.values && !(changes.tree && on_settings);
    if (isVisible()) {
        renew();
    }
}

void ChangePane::renew() {
    const bool values = std::exchange(stale_values_, false);
    if (std::exchange(stale_list_, false)) {
        list_owners();
    } else if (values) {
        listed_ == owners_of(state_.document()->scene()) ? show_values() : list_owners();
    }
    if (std::exchange(stale_ray_, false)) {
        follow_ray();
    }
    for (const auto& [button, command] : buttons_) {
        button->setEnabled(find_command(command)->possible(state_));
    }
}

void ChangePane::list_owners() {
    following_ = true;
    owners_->clear();
    listed_ = owners_of(state_.document()->scene());
    for (const KnobOwner owner : listed_) {
        owners_->addItem(qt(name_of(state_.document()->scene(), owner)));
    }
    following_ = false;
    show_owner();
}

void ChangePane::follow_ray() {
    if (!follows_->isChecked() || following_ || (!state_.selected() && !state_.thing())) {
        return;
    }
    const Scene& scene = state_.document()->scene();
    const auto owner = state_.thing() ? std::optional(owner_of(scene, *state_.thing()))
                                      : owner_of(scene, *state_.selected());
    const auto place = owner ? std::ranges::find(listed_, *owner) : listed_.end();
    if (place != listed_.end()) {
        owners_->setCurrentIndex(static_cast<int>(place - listed_.begin()));
    }
}

/// Rows anew, where they are others: sliders' ranges stay as they are while they are dragged.
void ChangePane::show_owner() {
    if (following_ || owners_->currentIndex() < 0) {
        return;
    }
    const KnobOwner owner = listed_[static_cast<std::size_t>(owners_->currentIndex())];
    const std::vector<Knob> knobs = knobs_of(state_.document()->scene(), owner);
    if (!rows_.empty() && std::ranges::equal(knobs, rows_, same_row, {}, &Row::knob)) {
        return show_values();
    }
    rows_.clear();
    auto* const box = new QWidget;
    auto* const form = new QFormLayout(box);
    form->setContentsMargins(0, 4, 4, 4);
    form->setVerticalSpacing(4);
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    rows_.reserve(knobs.size());
    for (const Knob& knob : knobs) {
        add_row(form, knob);
    }
    area_->setWidget(box);
    show_values();
}

void ChangePane::add_row(QFormLayout* form, const Knob& knob) {
    Row row{knob, nullptr, nullptr, nullptr};
    auto* const label = new QLabel(qt(knob.label));
    label->setToolTip(qt(knob.help + (knob.help.empty() ? "" : "  ") + "(" + knob.place + ")"));
    if (knob.kind == Knob::Kind::choice) {
        row.choice = new QComboBox;
        for (const std::string_view word : knob.words) {
            row.choice->addItem(qt(word));
        }
        row.choice->setAccessibleName(qt(knob.label));
        connect(row.choice, qOverload<int>(&QComboBox::activated), this, [this, knob](int place) {
            set(knob.place, std::string(knob.words[static_cast<std::size_t>(place)]), Pick::apart);
        });
        form->addRow(label, row.choice);
        rows_.push_back(row);
        return;
    }
    auto* const box = new QWidget;
    auto* const layout = new QHBoxLayout(box);
    layout->setContentsMargins(0, 0, 0, 0);
    row.slider = new QSlider(Qt::Horizontal);
    row.field = new QLineEdit;
    row.slider->setAccessibleName(qt(knob.label));
    row.field->setAccessibleName(qt(knob.label));
    const bool whole = knob.kind == Knob::Kind::whole;
    row.slider->setRange(whole ? static_cast<int>(knob.least) : 0,
                         whole ? static_cast<int>(knob.most) : slider_steps);
    row.slider->setPageStep(whole ? 1 : slider_steps / 20);
    const auto wide = [&](const char* text) {
        return row.field->fontMetrics().horizontalAdvance(QLatin1String(text)) + 14;
    };
    row.field->setMinimumWidth(wide("0.00, 0.00"));
    row.field->setMaximumWidth(wide("0.00, 0.00, 0.00"));  // all else is the slider's
    row.slider->setMinimumWidth(7 * fontMetrics().averageCharWidth());
    layout->addWidget(row.slider, 1);
    layout->addWidget(row.field);
    form->addRow(label, box);
    connect(row.slider, &QSlider::valueChanged, this,
            [this, row](int at) { take_slider(row, at); });
    connect(row.slider, &QSlider::sliderReleased, this, [this] { state_.let_go(); });
    connect(row.field, &QLineEdit::editingFinished, this, [this, row] {
        if (!following_ && !is_as_shown(*row.field)) {
            set(row.knob.place, row.field->text().toStdString(), Pick::apart);
        }
    });
    row.field->installEventFilter(this);
    rows_.push_back(row);
}

/// One change for a whole drag; a key or a click on the slider is one by itself.
void ChangePane::take_slider(const Row& row, int at) {
    if (!following_) {
        set(row.knob.place,
            slider_text(state_.document()->scene(), row.knob, value_at(row.knob, at)),
            row.slider->isSliderDown() ? Pick::on_the_way : Pick::apart);
    }
}

void ChangePane::set(const std::string& place, const std::string& text, Pick how) {
    try {
        run_command(state_, how == Pick::apart ? "change.set" : "change.drag", place + " " + text);
    } catch (const InputError& error) {
        show_values();
        fail_(error);
    }
}

/// Whoever is about to change a number sees all of it.
bool ChangePane::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::FocusIn || event->type() == QEvent::FocusOut) {
        auto& field = static_cast<QLineEdit&>(*watched);
        const bool comes = event->type() == QEvent::FocusIn;
        if (is_as_shown(field)) {
            field.setText(comes ? field.toolTip() : in_field(field, field.toolTip()));
            field.setCursorPosition(0);
        }
    }
    return QWidget::eventFilter(watched, event);
}

QString ChangePane::in_field(const QLineEdit& field, const QString& text) {
    constexpr int frame = 14;
    return in_room(text, field.fontMetrics(), field.maximumWidth() - frame);
}

/// Whether nothing else has been typed there.
bool ChangePane::is_as_shown(const QLineEdit& field) {
    return field.text() == field.toolTip() || field.text() == in_field(field, field.toolTip());
}

/// All of it stands in the tooltip.
void ChangePane::show_text(QLineEdit& field, const QString& text) {
    field.setToolTip(text);
    field.setText(field.hasFocus() ? text : in_field(field, text));
    field.setCursorPosition(0);
}

void ChangePane::show_values() {
    following_ = true;
    const Scene& scene = state_.document()->scene();
    for (const Row& row : rows_) {
        if (row.choice) {
            row.choice->setCurrentIndex(static_cast<int>(number_of(scene, row.knob)));
            continue;
        }
        show_text(*row.field, qt(text_of(scene, row.knob.place)));
        if (!row.slider->isSliderDown()) {
            row.slider->setValue(place_of(row.knob, number_of(scene, row.knob)));
        }
    }
    following_ = false;
}

}  // namespace raytree::inspector
