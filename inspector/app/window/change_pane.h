#pragma once

#include <QWidget>
#include <vector>

#include "state/state.h"

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLineEdit;
class QPushButton;
class QScrollArea;
class QSlider;

namespace raytree::inspector {

/// Sliders and fields for what of the scene can be changed: its settings, or one of its materials
/// or lights, chosen in the list or by the selected ray.
class ChangePane : public QWidget {
  public:
    /// `run` does what the buttons' commands do, `fail` is told why a value was refused.
    ChangePane(State& state, std::function<void(const std::string& command)> run,
               std::function<void(const InputError&)> fail, QWidget* parent = nullptr);

    QComboBox* owners() const { return owners_; }
    /// Of the knob of this place; null where it is not shown.
    QSlider* slider(const std::string& place) const;
    QLineEdit* field(const std::string& place) const;

  protected:
    void showEvent(QShowEvent*) override { renew(); }
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    static QString in_field(const QLineEdit& field, const QString& text);
    static bool is_as_shown(const QLineEdit& field);
    static void show_text(QLineEdit& field, const QString& text);
    struct Row {
        Knob knob;
        QSlider* slider = nullptr;
        QLineEdit* field = nullptr;
        QComboBox* choice = nullptr;
    };

    QWidget* make_buttons();
    void obey(const Changes& changes);
    void renew();
    void list_owners();
    void follow_ray();
    void show_owner();
    void add_row(QFormLayout* form, const Knob& knob);
    void show_values();
    void set(const std::string& place, const std::string& text, Pick how);
    void take_slider(const Row& row, int at);

    State& state_;
    std::function<void(const std::string& command)> run_;
    std::function<void(const InputError&)> fail_;
    QComboBox* owners_ = nullptr;
    QCheckBox* follows_ = nullptr;
    QScrollArea* area_ = nullptr;
    std::vector<std::pair<QPushButton*, const char*>> buttons_;  ///< and their commands
    std::vector<KnobOwner> listed_;
    std::vector<Row> rows_;
    // What the pane has yet to follow: it does so once it is seen.
    bool stale_list_ = false, stale_values_ = false, stale_ray_ = false;
    bool following_ = false;  ///< the pane follows the state, not the hand
};

}  // namespace raytree::inspector
