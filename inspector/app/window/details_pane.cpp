#include "window/details_pane.h"

#include <QFontDatabase>
#include <QScrollBar>

#include "state/derivation_details.h"
#include "state/details.h"
#include "state/formula_details.h"
#include "tree/explain.h"
#include "window/qt_text.h"

namespace raytree::inspector {
namespace {

QString escaped(const std::string& text) {
    return qt(text).toHtmlEscaped().replace(QLatin1Char(' '), QStringLiteral("&nbsp;"));
}

/// Details as rich text for Qt's subset of HTML.
class Writer {
  public:
    Writer(const Palette& palette, Quantize quantize) : palette_(palette), quantize_(quantize) {}

    void heading(const TreeRay<double>& ray) {
        const QString colour = qt(palette_[look_of(ray)]).name();
        html_ += QStringLiteral(
                     "<p style='margin:2px 0 2px 0; font-size:large'><b>"
                     "<span style='color:%1'>&#9632;</span>&nbsp;%2</b></p>")
                     .arg(colour, qt(title_of(ray)).toHtmlEscaped());
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
                                       .arg(qt(mixed(palette_.panel, palette_.accent, 0.22)).name())
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
            html_ += QStringLiteral("<p style='margin:1px 0 3px 0'>%1</p>")
                         .arg(qt(sentence).toHtmlEscaped());
        }
    }

    QString take() { return std::move(html_); }

  private:
    void add(const DetailRow& row) {
        const bool faint = row.weight == DetailRow::Weight::faint;
        const bool strong = row.weight == DetailRow::Weight::strong;
        const QString label_colour = qt(palette_.dim_text).name();
        const QString colour = faint ? label_colour : qt(palette_.text).name();
        html_ += QStringLiteral("<tr><td width='31%' style='color:%1'>%2%3%4%5</td>")
                     .arg(strong ? colour : label_colour, strong ? "<b>" : "", escaped(row.label),
                          strong ? "</b>" : "", swatch_of(row));
        for (const std::string& cell : row.cells) {
            html_ += row.is_text ? QStringLiteral("<td colspan='3' align='left'>%1</td>")
                                       .arg(qt(cell).toHtmlEscaped())
                                 : QStringLiteral(
                                       "<td width='23%' align='right' style='color:%1; "
                                       "font-family:%2'>%3%4%5</td>")
                                       .arg(colour, mono_, strong ? "<b>" : "", escaped(cell),
                                            strong ? "</b>" : "");
        }
        if (!row.is_text && row.cells.size() < 3) {
            html_ += QStringLiteral("<td colspan='%1'></td>").arg(3 - row.cells.size());
        }
        html_ += QStringLiteral("</tr>");
    }

    QString swatch_of(const DetailRow& row) const {
        if (!row.swatch) {
            return {};
        }
        const auto [r, g, b] = eight_bit(*row.swatch, quantize_).value;
        return QStringLiteral(
                   "&nbsp;&nbsp;<span style='background-color:%1'>"
                   "&nbsp;&nbsp;&nbsp;&nbsp;&nbsp;</span>")
            .arg(QColor(r, g, b).name());
    }

    const Palette& palette_;
    Quantize quantize_;
    QString mono_ = QFontDatabase::systemFont(QFontDatabase::FixedFont).family();
    QString html_;
};

}  // namespace

DetailsPane::DetailsPane(State& state, QWidget* parent) : QTextBrowser(parent), state_(state) {
    setOpenLinks(false);
    document()->setDocumentMargin(8);
    state_.observe([this](const Changes& changes) {
        if (changes.selection || changes.tree || changes.look || changes.lesson ||
            changes.explained) {
            show_ray();
        }
    });
}

void DetailsPane::show_ray() {
    const Palette& palette = palette_of(state_.look().theme);
    if (!state_.tree()) {
        setPlainText(qt(state_.message()));
        return;
    }
    Writer writer(palette, state_.tree()->tree.settings.quantize);
    writer.heading(*state_.selected());
    writer.equation(*state_.selected());
    const auto formula = marked_formula(state_);
    const auto write = [&](const std::vector<DetailSection>& sections) {
        for (const DetailSection& section : sections) {
            writer.section(section, formula && is_about(section, *formula));
        }
    };
    write(formula_details(state_));
    write(details_of(*state_.tree(), state_.selected()->id));
    write(derivation_details(
        derive(state_.document()->world(), state_.tree()->tree, state_.selected()->id)));
    setHtml(writer.take());
    verticalScrollBar()->setValue(0);
    if (formula) {
        scrollToAnchor(QStringLiteral("marked"));
    }
}

}  // namespace raytree::inspector
