// What the page of trends writes and keeps: pictures, tables, layouts; and what is dropped into it.

#include "ui/models/sitetreemodel.h"
#include "ui/plots/trendcsv.h"
#include "ui/plots/trendlayouts.h"
#include "ui/plots/trendplot.h"
#include "ui/plots/trendspage.h"

#include <QDropEvent>
#include <QFileDialog>
#include <QInputDialog>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QSaveFile>
#include <QSettings>

namespace gorizont {

namespace {

const QString namedLayouts = QStringLiteral("trends/layouts");
const QString lastLayout = QStringLiteral("trends/last");

/// The same file as that of the window.
QSettings windowSettings()
{
    const QString name = QStringLiteral("Gorizont Server");
    return QSettings(QSettings::NativeFormat, QSettings::UserScope, name, name);
}

QString suffixOf(TrendsPage::Export form)
{
    switch (form) {
    case TrendsPage::Export::Png: return QStringLiteral("png");
    case TrendsPage::Export::Pdf: return QStringLiteral("pdf");
    case TrendsPage::Export::ExcelCsv:
    case TrendsPage::Export::IsoCsv: break;
    }
    return QStringLiteral("csv");
}

bool writeWhole(const QString &path, const QByteArray &bytes)
{
    QSaveFile file(path);
    return file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size() && file.commit();
}

} // namespace

bool TrendsPage::exportTo(const QString &path, Export form)
{
    const TimeSpan span = m_plot->span();
    switch (form) {
    case Export::Png: return m_plot->savePng(path, 0, 0, devicePixelRatioF());
    case Export::Pdf: return m_plot->savePdf(path, 0, 0, QCP::epAllowCosmetic, windowTitle());
    case Export::ExcelCsv:
    case Export::IsoCsv: break;
    }
    const ExportFormat format = form == Export::ExcelCsv ? ExportFormat::CsvRussian : ExportFormat::CsvIso;
    QList<CsvCurve> table;
    for (const TrendCurve &curve : m_drawn) {
        const auto index = static_cast<std::size_t>(m_registry.indexOf(curve.key.number));
        const Series series = m_feed->whole(curve.key);
        table.append(
            {csvColumn(
                 m_registry.sensors()[index].config, curve.key.quantity, format, series.step.count() > 0,
                 m_unit == TiltUnit::Degrees),
             series});
    }
    return writeWhole(path, trendCsv(table, span, format, QTimeZone::systemTimeZone()));
}

/// Returns at once; the file is written when a name has been chosen.
void TrendsPage::askExport(Export form)
{
    const QString suffix = suffixOf(form);
    auto *dialog = new QFileDialog(this, tr("Save what is seen"));
    dialog->setObjectName(QStringLiteral("exportDialog"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setNameFilter(QStringLiteral("*.") + suffix);
    dialog->setDefaultSuffix(suffix);
    connect(dialog, &QFileDialog::fileSelected, this, [this, form](const QString &path) {
        if (!exportTo(path, form)) {
            tell(tr("%1 cannot be written. Choose another folder, or close the program that has the file open.")
                     .arg(path));
        }
    });
    dialog->open();
}

void TrendsPage::tell(const QString &text)
{
    auto *box = new QMessageBox(QMessageBox::Warning, window()->windowTitle(), text, QMessageBox::Ok, this);
    box->setObjectName(QStringLiteral("trendMessage"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->open();
}

TrendLayout TrendsPage::layoutNow(const QString &name) const
{
    const TimeSpan span = m_plot->span();
    return {name, curves(), std::chrono::round<std::chrono::seconds>(span.to - span.from), m_unit};
}

/// A layout says how long a span is, never when: it shows the present.
void TrendsPage::applyLayout(const TrendLayout &layout)
{
    setUnit(layout.unit);
    showCurves(layout.curves);
    follow(layout.span);
}

void TrendsPage::keepLayout(const QString &name)
{
    QSettings settings = windowSettings();
    QList<TrendLayout> layouts = readTrendLayouts(settings, namedLayouts);
    layouts.removeIf([&name](const TrendLayout &layout) { return layout.name == name; });
    layouts.append(layoutNow(name));
    writeTrendLayouts(settings, namedLayouts, layouts);
}

void TrendsPage::askLayoutName()
{
    auto *dialog = new QInputDialog(this);
    dialog->setObjectName(QStringLiteral("layoutName"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(tr("Keep the layout"));
    dialog->setLabelText(tr("Curves and span are kept under this name:"));
    connect(dialog, &QInputDialog::textValueSelected, this, [this](const QString &name) {
        if (!name.trimmed().isEmpty()) {
            keepLayout(name.trimmed());
        }
    });
    dialog->open();
}

void TrendsPage::fillLayouts(QMenu *menu)
{
    menu->clear();
    QSettings settings = windowSettings();
    const QList<TrendLayout> layouts = readTrendLayouts(settings, namedLayouts);
    auto *forget = new QMenu(tr("&Delete"), menu);
    for (const TrendLayout &layout : layouts) {
        QString title = layout.name;
        title.replace(u'&', QStringLiteral("&&"));
        menu->addAction(title, this, [this, layout] { applyLayout(layout); });
        forget->addAction(title, this, [name = layout.name] {
            QSettings kept = windowSettings();
            QList<TrendLayout> others = readTrendLayouts(kept, namedLayouts);
            others.removeIf([&name](const TrendLayout &other) { return other.name == name; });
            writeTrendLayouts(kept, namedLayouts, others);
        });
    }
    menu->addSeparator();
    QAction *keep = menu->addAction(tr("&Keep as…"), this, &TrendsPage::askLayoutName);
    keep->setEnabled(!curves().isEmpty());
    menu->addMenu(forget)->setEnabled(!layouts.isEmpty());
}

void TrendsPage::restoreLast()
{
    QSettings settings = windowSettings();
    const QList<TrendLayout> last = readTrendLayouts(settings, lastLayout);
    applyLayout(last.value(0));
}

void TrendsPage::keepLast() const
{
    QSettings settings = windowSettings();
    writeTrendLayouts(settings, lastLayout, {layoutNow({})});
}

void TrendsPage::dragEnterEvent(QDragEnterEvent *event)
{
    if (event->mimeData()->hasFormat(SiteTreeModel::sensorsFormat())) {
        event->acceptProposedAction();
    }
}

void TrendsPage::dropEvent(QDropEvent *event)
{
    for (const int number : SiteTreeModel::sensorsOf(*event->mimeData())) {
        addSensor(number);
    }
    event->acceptProposedAction();
}

} // namespace gorizont
