// What the page of trends says in words and numbers: its hint, its state, and what the cursors read.

#include "ui/plots/cursorpair.h"
#include "ui/plots/cursorpanel.h"
#include "ui/plots/trendplot.h"
#include "ui/plots/trendspage.h"

#include <QLabel>

namespace gorizont {

void TrendsPage::showCursors(bool isShown)
{
    m_readout->setVisible(isShown);
    m_cursors->setShown(isShown);
}

void TrendsPage::updateCursors()
{
    if (!m_cursors->isShown()) {
        return;
    }
    QList<CursorModel::Row> rows;
    for (const TrendCurve &curve : m_drawn) {
        rows.append(cursorRow(curve, m_feed->whole(curve.key), m_cursors->first(), m_cursors->second()));
    }
    m_readout->setRows(rows, m_unit);
    m_readout->setMoments(m_cursors->first(), m_cursors->second());
}

void TrendsPage::updateHint()
{
    if (curves().isEmpty()) {
        m_hint->setText(
            tr("Nothing is drawn yet. Tick values in the list on the left, or drag a sensor from the tree into "
               "this field."));
    } else if (m_feed->isWaiting() || m_plot->hasValues()) {
        m_hint->clear();
    } else {
        m_hint->setText(
            tr("There are no values in this span. Choose a longer span, or move to another time by dragging."));
    }
    m_hint->setVisible(!m_hint->text().isEmpty());
}

void TrendsPage::updateTexts()
{
    updateHint();
    const TimeSpan shown = m_plot->span();
    if (m_feed->hasFailed()) {
        m_state->setText(tr("The archive does not answer; only what comes now is drawn. The journal says why."));
    } else if (m_feed->isWaiting()) {
        m_state->setText(tr("Reading…"));
    } else {
        const QString seen = tr("%1 – %2").arg(plottext::moment(shown.from), plottext::moment(shown.to));
        m_state->setText(m_files ? tr("%1   Old files: %2").arg(seen, m_filesPath) : seen);
    }
}

} // namespace gorizont
