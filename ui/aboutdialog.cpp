#include "ui/aboutdialog.h"

#include "ui/models/icons.h"

#include <QCoreApplication>
#include <QMessageBox>
#include <QPushButton>

namespace gorizont {

namespace {

/// The translation context of the dialog.
struct About
{
    Q_DECLARE_TR_FUNCTIONS(About)
};

} // namespace

void showAbout(QWidget *parent)
{
    auto *box = new QMessageBox(parent);
    box->setObjectName(QStringLiteral("aboutDialog"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setWindowTitle(About::tr("About"));
    box->setIconPixmap(icons::program().pixmap(QSize(64, 64), box->devicePixelRatioF()));
    box->setText(QStringLiteral("<b>Gorizont Server</b> ") + QStringLiteral(GORIZONT_VERSION));
    box->setInformativeText(
        About::tr("Watches buildings: polls inclinometers and accelerometers, shows, saves and serves their readings.")
        + QStringLiteral("\n\n")
        + About::tr("Free software under the GNU General Public License, version 3. It comes without any warranty.")
        + QStringLiteral("\n\n") + About::tr("Built with Qt %1").arg(QLatin1String(qVersion())));
    box->addButton(About::tr("Close"), QMessageBox::AcceptRole)->setObjectName(QStringLiteral("aboutClose"));
    box->open();
}

} // namespace gorizont
