// The only place of the main program that differs on Windows.

#include "app/server/gatewayregistration.h"

#include <QCoreApplication>
#include <QDir>

#ifdef Q_OS_WIN
#include <QFileInfo>
#include <QProcess>
#endif

namespace gorizont {

QStringList registrationArguments(int port, const QByteArray &hash, const QString &tagsFile)
{
    return {
        QStringLiteral("/RegServer"), QStringLiteral("/Port=%1").arg(port),
        QStringLiteral("/Hash=%1").arg(QLatin1String(hash)),
        QStringLiteral("/Tags=%1").arg(QDir::toNativeSeparators(tagsFile))};
}

#ifdef Q_OS_WIN

namespace {

struct RegistrationText
{
    Q_DECLARE_TR_FUNCTIONS(GatewayRegistration)
};

} // namespace

bool canRegisterGateways()
{
    return true;
}

void registerGateway(const QStringList &arguments, QObject *context, const std::function<void(QString)> &done)
{
    const QString gateway =
        QDir(QCoreApplication::applicationDirPath()).filePath(QStringLiteral("gorizont-opc-da.exe"));
    if (!QFileInfo::exists(gateway)) {
        done(RegistrationText::tr("%1 is missing. Install the program with its OPC DA part.")
                 .arg(QDir::toNativeSeparators(gateway)));
        return;
    }
    auto *process = new QProcess(context);
    QObject::connect(process, &QProcess::finished, context, [process, done](int code, QProcess::ExitStatus) {
        process->deleteLater();
        done(
            code == 0
                ? QString()
                : RegistrationText::tr("Windows has refused it (error %1). Start the program once as administrator.")
                      .arg(code));
    });
    QObject::connect(process, &QProcess::errorOccurred, context, [process, done](QProcess::ProcessError error) {
        if (error == QProcess::FailedToStart) {
            process->deleteLater();
            done(RegistrationText::tr("The gateway does not start (%1).").arg(process->errorString()));
        }
    });
    process->start(gateway, arguments);
}

#else

bool canRegisterGateways()
{
    return false;
}

void registerGateway(const QStringList &, QObject *, const std::function<void(QString)> &done)
{
    done({});
}

#endif

} // namespace gorizont
