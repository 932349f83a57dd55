#include "app/tool/exportcommand.h"

#include "app/tool/output.h"
#include "app/tool/terminal.h"
#include "app/tool/text.h"
#include "core/export/exportrun.h"

#include <QJsonArray>

#include <csignal>

namespace gorizont::tool {

namespace {

using Qt::Literals::StringLiterals::operator""_s;

/// As long as it lives, Ctrl+C and SIGTERM end an export instead of the program. One at a time.
class ExportInterruption
{
public:
    explicit ExportInterruption(ExportWatch &watch)
    {
        interruptible = &watch.isCancelled;
        std::signal(SIGINT, onInterrupt);
        std::signal(SIGTERM, onInterrupt);
    }
    ~ExportInterruption()
    {
        std::signal(SIGINT, SIG_DFL);
        std::signal(SIGTERM, SIG_DFL);
        interruptible = nullptr;
    }
    Q_DISABLE_COPY_MOVE(ExportInterruption)

private:
    static void onInterrupt(int number)
    {
        std::signal(number, onInterrupt); // some systems forget it
        if (std::atomic_bool *isCancelled = interruptible.load()) {
            *isCancelled = true;
        }
    }

    static inline std::atomic<std::atomic_bool *> interruptible{nullptr};
    static_assert(std::atomic<std::atomic_bool *>::is_always_lock_free && std::atomic_bool::is_always_lock_free);
};

} // namespace

ExitCode exportHistory(const ExportRequest &request, const ArchiveSource &source, bool isJson)
{
    ExportWatch watch;
    const ExportInterruption interruption(watch);
    watch.progress = [](int percent, quint64 rows) { showProgress(Text::tr("%1 %, %2 rows").arg(percent).arg(rows)); };
    const ExportResult result = runExport(request, source, watch);
    showProgress({});
    if (!result.files.isEmpty() && result.failure.isEmpty()) {
        if (isJson) {
            print(QJsonObject{
                {u"rows"_s, static_cast<qint64>(result.rows)}, {u"files"_s, QJsonArray::fromStringList(result.files)}});
        } else {
            print(Text::tr("%1 rows: %2").arg(result.rows).arg(result.files.join(u", "_s)));
        }
        return ExitGood;
    }
    complain(result.isCancelled ? Text::tr("cancelled; nothing was written") : result.failure);
    return result.isCancelled ? ExitRefused : ExitNoAnswer;
}

} // namespace gorizont::tool
