#include "translations/translation.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QTranslator>

namespace gorizont {

namespace {

/// Belongs to the application; one of each name at a time.
bool replaceTranslator(const QString &objectName, const QString &file)
{
    QCoreApplication *application = QCoreApplication::instance();
    delete application->findChild<QTranslator *>(objectName, Qt::FindDirectChildrenOnly);
    auto *translator = new QTranslator(application);
    translator->setObjectName(objectName);
    if (!translator->load(file)) {
        delete translator;
        return false;
    }
    return QCoreApplication::installTranslator(translator);
}

} // namespace

bool installTranslation(const QString &language)
{
    const QString chosen = language.isEmpty() ? QStringLiteral("ru") : language.toLower();
    const QString qtFolder = QLibraryInfo::path(QLibraryInfo::TranslationsPath);
    replaceTranslator(QStringLiteral("qtTranslator"), QStringLiteral("%1/qtbase_%2.qm").arg(qtFolder, chosen));
    return replaceTranslator(QStringLiteral("gorizontTranslator"), QStringLiteral(":/i18n/gorizont_%1.qm").arg(chosen));
}

} // namespace gorizont
