#include "window/details_pane.h"

#include <QContextMenuEvent>
#include <QFontDatabase>
#include <QMenu>
#include <QPainter>
#include <QScrollBar>
#include <QToolTip>
#include <memory>

#include "state/commands.h"
#include "state/derivation_details.h"
#include "state/details.h"
#include "state/formula_details.h"
#include "state/lighting_details.h"
#include "state/marked_texts.h"
#include "state/numbers.h"
#include "state/thing_details.h"
#include "tree/eight_bit.h"
#include "window/qt_text.h"
#include "window/rich_text.h"

namespace raytree::inspector {
namespace {

QString escaped(const std::string& text) {
    return qt(text).toHtmlEscaped().replace(QLatin1Char(' '), QStringLiteral("&nbsp;"));
}

/// Formulas stay on one line.
QString unbroken(const std::string& sentence) {
    QString text = qt(sentence).toHtmlEscaped();
    for (const char* const sign : {"·", "≤", "=", "→"}) {
        const QString in = QString::fromUtf8(sign);
        text.replace(QLatin1Char(' ') + in + QLatin1Char(' '),
                     QStringLiteral("&nbsp;") + in + QStringLiteral("&nbsp;"));
    }
    return text;
}

/// Names that are longer than a column is wide may go on below.
QString breakable(QString name) {
    constexpr int room = 11;  // letters
    return name.size() <= room ? name : name.replace(QLatin1Char('_'), QStringLiteral("_&#8203;"));
}

/// Details as rich text for Qt's subset of HTML.
class Writer {
  public:
    Writer(const Palette& palette, Quantize quantize) : palette_(palette), quantize_(quantize) {}

    void heading(const std::string& title, Ink ink) {
        const QString colour = qt(ink).name();
        html_ += QStringLiteral(
                     "<p style='margin:2px 0 2px 0; font-size:large'><b>"
                     "<span style='color:%1'>&#9632;</span>&nbsp;%2</b></p>")
                     .arg(colour, qt(title).toHtmlEscaped());
    }

    void equation(const TreeRay<double>& ray) {
        if (ray.hit) {
            html_ += QStringLiteral(
                         "<p style='margin:4px 0 0 0; color:%1'><i>I</i> = ambient + "
                         "diffuse + specular + kr·f·<i>I</i><sub>r</sub> + "
                         "kt·f·<i>I</i><sub>t</sub></p>")
                         .arg(qt(palette_.dim_text).name());
        }
    }

    /// A section that a lesson talks about bears a mark.
    void section(const DetailSection& section, bool marked = false) {
        const QString mark = marked
                                 ? QStringLiteral("; background-color:%1")
                                       .arg(qt(mixed(palette_.panel, palette_.accent, 0.1)).name())
                                 : QString();
        html_ += QStringLiteral("<p style='margin:9px 0 2px 0; color:%1%2'><b>%3%4</b></p>")
                     .arg(qt(palette_.accent).name(), mark,
                          marked ? QStringLiteral("<a name='marked'></a>▸ ") : QString(),
                          qt(section.title).toHtmlEscaped());
        if (!section.rows.empty()) {
            html_ += QStringLiteral("<table cellspacing='0' cellpadding='1' width='100%'>");
            for (const DetailRow& row : section.rows) {
                add(row);
            }
            html_ += QStringLiteral("</table>");
        }
        for (const std::string& sentence : section.sentences) {
            html_ += QStringLiteral("<p style='margin:1px 0 3px 0'>%1</p>").arg(unbroken(sentence));
        }
    }

    QString take() { return std::move(html_); }
    /// The numbers that have been written, in their order: "n:3" leads to the fourth.
    std::vector<double> take_numbers() { return std::move(numbers_); }

  private:
    void add(const DetailRow& row) {
        const bool faint = row.weight == DetailRow::Weight::faint;
        const bool strong = row.weight == DetailRow::Weight::strong;
        const QString label_colour = qt(palette_.dim_text).name();
        if (row.is_text && row.cells.front().empty()) {  // a label for the rows below it
            html_ += QStringLiteral("<tr><td colspan='4' style='color:%1'>%2</td></tr>")
                         .arg(label_colour, escaped(row.label));
            return;
        }
        const QString colour = faint ? label_colour : qt(palette_.text).name();
        html_ += QStringLiteral(
                     "<tr><td width='35%' style='color:%1; padding-right:6px%2'>%3%4%5%6</td>")
                     .arg(strong ? colour : label_colour,
                          row.swatch ? "; white-space:nowrap" : "",  // it touches no number
                          strong ? "<b>" : "", breakable(escaped(row.label)), strong ? "</b>" : "",
                          swatch_of(row));
        for (std::size_t k = 0; k < row.cells.size(); ++k) {
            add_cell(row, k, colour, strong);
        }
        if (!row.is_text && row.cells.size() < 3) {
            html_ += QStringLiteral("<td colspan='%1'>&nbsp;</td>").arg(3 - row.cells.size());
        }
        html_ += QStringLiteral("</tr>");
    }

    void add_cell(const DetailRow& row, std::size_t k, const QString& colour, bool strong) {
        QString text = row.is_text ? qt(row.cells[k]).toHtmlEscaped() : escaped(row.cells[k]);
        if (k < row.rays.size()) {
            text = link(QStringLiteral("r:%1").arg(row.rays[k]), text, qt(palette_.accent).name());
        } else if (k < row.values.size()) {
            text = link(QStringLiteral("n:%1").arg(numbers_.size()), text, colour);
            numbers_.push_back(row.values[k]);
        }
        html_ += row.is_text
                     ? QStringLiteral("<td colspan='3' align='left'>%1</td>").arg(text)
                     : QStringLiteral(
                           "<td align='right' style='color:%1; padding-left:5px; "
                           "font-family:%2; white-space:nowrap'>%3%4%5</td>")
                           .arg(colour, mono_, strong ? "<b>" : "", text, strong ? "</b>" : "");
    }

    static QString link(const QString& to, const QString& text, const QString& colour) {
        return QStringLiteral("<a href='%1' style='color:%2; text-decoration:none'>%3</a>")
            .arg(to, colour, text);
    }

    QString swatch_of(const DetailRow& row) const {
        if (!row.swatch) {
            return {};
        }
        const auto [r, g, b] = eight_bit(*row.swatch, quantize_).value;
        return QStringLiteral("&nbsp;<img src='swatch:%1'/>").arg(QColor(r, g, b).name().mid(1));
    }

    const Palette& palette_;
    Quantize quantize_;
    QString mono_ = QFontDatabase::systemFont(QFontDatabase::FixedFont).family();
    QString html_;
    std::vector<double> numbers_;
};

}  // namespace

DetailsPane::DetailsPane(State& state, QWidget* parent) : QTextBrowser(parent), state_(state) {
    setOpenLinks(false);
    setWordWrapMode(QTextOption::WordWrap);  // a column is as wide as its longest word
    setAccessibleName(QStringLiteral("Details of what is selected"));
    document()->setDocumentMargin(8);
    connect(this, &QTextBrowser::anchorClicked, this, &DetailsPane::follow);
    connect(this, qOverload<const QUrl&>(&QTextBrowser::highlighted), this, &DetailsPane::hint);
    state_.observe([this](const Changes& changes) {
        if (changes.selection || changes.tree || changes.look || changes.playback ||
            changes.lesson || changes.explained) {
            show_selection(changes.lesson);
        }
        if (changes.request == Request::copy_number) {
            copy_number();
        }
    });
}

/// Framed, so that the colour of the background is seen as well.
QVariant DetailsPane::loadResource(int type, const QUrl& name) {
    if (name.scheme() != QStringLiteral("swatch")) {
        return QTextBrowser::loadResource(type, name);
    }
    const int height = fontMetrics().height() - 4;
    const double ratio = devicePixelRatioF();
    QImage image(QSize(height, height) * ratio, QImage::Format_RGB32);
    image.setDevicePixelRatio(ratio);
    image.fill(QColor(QLatin1Char('#') + name.path()));
    QPainter painter(&image);
    painter.setPen(QPen(qt(palette_of(state_.look().theme).dim_text), 1));
    painter.drawRect(QRectF(0.5, 0.5, height - 1, height - 1));
    return image;
}

void DetailsPane::show_selection(bool anew) {
    number_.reset();
    if (!state_.thing() && !state_.tree()) {
        setPlainText(qt(state_.message()));
        shown_.clear();
        return;
    }
    const Palette& palette = palette_of(state_.look().theme);
    Writer writer(palette, state_.document()->scene().settings.quantize);
    if (state_.thing()) {
        const Scene& scene = state_.document()->scene();
        const Thing thing = *state_.thing();
        writer.heading(title_of(scene, thing), palette.selection);
        for (const DetailSection& section : details_of(scene, state_.tree().get(), thing)) {
            writer.section(section);
        }
    } else {
        write_ray(writer);
    }
    numbers_ = writer.take_numbers();
    const QString html = writer.take();
    if (html == shown_ && !anew) {
        return;
    }
    if (html != shown_) {
        show_html(*this, html);
        shown_ = html;
    }
    verticalScrollBar()->setValue(0);
    if (marked_formula(state_) && !state_.thing()) {
        scrollToAnchor(QStringLiteral("marked"));
    }
}

template <class Writer> void DetailsPane::write_ray(Writer& writer) const {
    const TreeRay<double>& ray = *state_.selected();
    writer.heading(marked_title_of(*state_.tree(), ray.id),
                   palette_of(state_.look().theme)[look_of(ray)]);
    writer.equation(ray);
    const auto formula = marked_formula(state_);
    const auto write = [&](const std::vector<DetailSection>& sections) {
        for (const DetailSection& section : sections) {
            writer.section(section, formula && is_about(section, *formula));
        }
    };
    const PixelTree& tree = *state_.tree();
    write(formula_details(state_));
    write(known_details(tree, ray.id, state_.playback()));
    if (can_derive(tree, ray.id, state_.playback())) {
        if (!state_.playback() || state_.playback()->stage(ray.id) == Stage::evaluated) {
            write(lighting_details(*state_.document(), tree, ray.id));
        }
        write(derivation_details(derive(state_.document()->world(), tree.tree, ray.id)));
    }
}

/// A number is copied, a ray selected.
void DetailsPane::follow(const QUrl& link) {
    const std::size_t k = link.path().toUInt();
    if (link.scheme() == QStringLiteral("r")) {
        state_.select(k);
    } else if (k < numbers_.size()) {
        number_ = numbers_[k];
        copy_number();
    }
}

/// The number under the mouse, or to which Tab has come, with all of its digits.
void DetailsPane::hint(const QUrl& link) {
    const std::size_t k = link.path().toUInt();
    if (link.scheme() != QStringLiteral("n") || k >= numbers_.size()) {
        QToolTip::hideText();
        return;
    }
    number_ = numbers_[k];
    QToolTip::showText(QCursor::pos(), qt(exact(*number_)) + QStringLiteral("\na click copies it"),
                       this);
}

void DetailsPane::copy_number() {
    const QUrl come_to(textCursor().hasSelection() ? textCursor().charFormat().anchorHref()
                                                   : QString());
    if (come_to.scheme() == QStringLiteral("n") && come_to.path().toUInt() < numbers_.size()) {
        number_ = numbers_[come_to.path().toUInt()];
    }
    if (!number_) {
        state_.say("No number is chosen: point at one in the details, or go to it with Tab.");
        return;
    }
    state_.request(Request::copy_text, exact(*number_));
    state_.say("Copied: " + exact(*number_));
}

void DetailsPane::contextMenuEvent(QContextMenuEvent* event) {
    const QUrl link(anchorAt(event->pos()));
    if (link.scheme() == QStringLiteral("n") && link.path().toUInt() < numbers_.size()) {
        number_ = numbers_[link.path().toUInt()];
    }
    const std::unique_ptr<QMenu> menu(createStandardContextMenu());
    menu->addSeparator();
    for (const char* const id : {"copy.number", "copy.ray_text", "copy.ray_json"}) {
        const Command& command = *find_command(id);
        QString title = qt(command.title);
        if (command.id == "copy.number" && number_) {
            title += QStringLiteral("  ") + qt(exact(*number_));
        }
        menu->addAction(title, [this, id] { run_command(state_, id); })
            ->setEnabled(command.id != "copy.number" || number_);
    }
    menu->exec(event->globalPos());
}

}  // namespace raytree::inspector
