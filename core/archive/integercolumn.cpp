#include "core/archive/integercolumn.h"

#include "core/archive/bitstream.h"

#include <algorithm>
#include <array>

namespace gorizont {

namespace {

enum Predictor : quint8 { Constant, Previous, Continued, Straight };

constexpr std::size_t blockSize = 64;
constexpr int allZero = 63;
constexpr int mostK = 57;
constexpr int escapeOnes = 24;
constexpr qint64 farthest = qint64{1} << 46; ///< a straight line stays within 64 bits

qint64 wrapped(quint64 value)
{
    return static_cast<qint64>(value);
}
quint64 bitsOf(qint64 value)
{
    return static_cast<quint64>(value);
}

struct Model
{
    Predictor predictor = Constant;
    qint64 first = 0; ///< the parameter
    qint64 slope = 0; ///< in 1/65536

    qint64 predict(std::size_t i, qint64 before, qint64 beforeThat) const
    {
        switch (predictor) {
        case Constant: return first;
        case Previous: return i == 0 ? first : before;
        case Continued: return i < 2 ? (i == 0 ? first : before) : wrapped(2 * bitsOf(before) - bitsOf(beforeThat));
        case Straight: return wrapped(bitsOf(first) + bitsOf(wrapped(bitsOf(slope) * i) >> 16));
        }
        return first;
    }
};

struct BlockPlan
{
    int k = allZero;
    bool isFlagged = false;
    quint64 bits = 0;
};

quint64 riceBits(std::span<const quint64> residuals, int k, quint64 less)
{
    quint64 bits = 0;
    for (const quint64 residual : residuals) {
        if (residual >= less) {
            const quint64 high = (residual - less) >> k;
            bits += high < escapeOnes ? high + 1 + static_cast<quint64>(k) : escapeOnes + 64;
        }
    }
    return bits;
}

/// The best k is near the logarithm of the mean.
BlockPlan planBlock(std::span<const quint64> residuals)
{
    quint64 sum = 0;
    std::size_t zeros = 0;
    for (const quint64 residual : residuals) {
        sum += std::min(residual, quint64{1} << 57);
        zeros += residual == 0;
    }
    if (sum == 0) {
        return {};
    }
    BlockPlan best{0, false, ~quint64{0}};
    const auto consider = [&](quint64 count, quint64 less, quint64 extra) {
        const int guess = std::min<int>(mostK, std::bit_width(std::max<quint64>(1, sum / count)));
        for (int k = std::max(0, guess - 2); k <= guess; ++k) {
            const quint64 bits = riceBits(residuals, k, less) + extra;
            if (bits < best.bits) {
                best = {k, less == 1, bits};
            }
        }
    };
    consider(residuals.size(), 0, 0);
    if (zeros * 4 > residuals.size()) {
        consider(residuals.size() - zeros, 1, residuals.size());
    }
    return best;
}

void putRice(BitWriter &writer, quint64 value, int k)
{
    const quint64 high = value >> k;
    if (high < escapeOnes) {
        writer.put((quint64{1} << high) - 1, static_cast<int>(high) + 1);
        writer.put(value & ((quint64{1} << k) - 1), k);
    } else {
        writer.put((quint64{1} << escapeOnes) - 1, escapeOnes);
        writer.put(value, 64);
    }
}

void putBlock(BitWriter &writer, std::span<const quint64> residuals)
{
    const BlockPlan plan = planBlock(residuals);
    writer.put(static_cast<quint64>(plan.k) | (plan.isFlagged ? 64U : 0U), 7);
    if (plan.k == allZero) {
        return;
    }
    for (const quint64 residual : residuals) {
        if (plan.isFlagged) {
            writer.put(residual != 0 ? 1 : 0, 1);
        }
        if (!plan.isFlagged) {
            putRice(writer, residual, plan.k);
        } else if (residual != 0) {
            putRice(writer, residual - 1, plan.k);
        }
    }
}

void findResiduals(const Model &model, std::span<const qint64> values, std::vector<quint64> &residuals)
{
    qint64 before = 0;
    qint64 beforeThat = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        residuals[i] = zigzag(wrapped(bitsOf(values[i]) - bitsOf(model.predict(i, before, beforeThat))));
        beforeThat = before;
        before = values[i];
    }
}

/// About how many bits the residuals take; only for choosing.
quint64 estimate(std::span<const quint64> residuals)
{
    quint64 bits = 0;
    for (std::size_t at = 0; at < residuals.size(); at += blockSize) {
        const auto block = residuals.subspan(at, std::min(blockSize, residuals.size() - at));
        quint64 sum = 0;
        quint64 others = 0;
        for (const quint64 residual : block) {
            sum += std::min(residual, quint64{1} << 57);
            others += residual != 0;
        }
        if (sum > 0) {
            const auto plain = block.size() * static_cast<std::size_t>(std::bit_width(sum / block.size()) + 1);
            const auto flagged = block.size() + others * static_cast<std::size_t>(std::bit_width(sum / others) + 1);
            bits += std::min<quint64>(plain, flagged);
        }
    }
    return bits;
}

qint64 middleOf(std::span<const qint64> values)
{
    double sum = 0;
    for (const qint64 value : values) {
        sum += static_cast<double>(value);
    }
    const double mean = sum / static_cast<double>(values.size());
    return std::abs(mean) < static_cast<double>(farthest) ? std::llround(mean) : values.front();
}

std::vector<Model> candidates(std::span<const qint64> values)
{
    const qint64 first = values.front();
    std::vector<Model> models{{Constant, middleOf(values)}, {Previous, first}, {Continued, first}};
    const qint64 distance = wrapped(bitsOf(values.back()) - bitsOf(first));
    if (values.size() > 2 && distance > -farthest && distance < farthest) {
        models.push_back({Straight, first, distance * 65536 / static_cast<qint64>(values.size() - 1)});
    }
    return models;
}

} // namespace

void appendIntegers(ArchiveBytes &bytes, std::span<const qint64> values)
{
    if (values.empty()) {
        return;
    }
    std::vector<quint64> best;
    std::vector<quint64> residuals(values.size());
    Model model;
    quint64 fewest = ~quint64{0};
    for (const Model &candidate : candidates(values)) {
        findResiduals(candidate, values, residuals);
        if (const quint64 bits = estimate(residuals); bits < fewest) {
            fewest = bits;
            model = candidate;
            best = residuals;
        }
    }
    bytes.number(model.predictor);
    bytes.signedNumber(model.first);
    if (model.predictor == Straight) {
        bytes.signedNumber(model.slope);
    }
    BitWriter writer;
    for (std::size_t at = 0; at < best.size(); at += blockSize) {
        putBlock(writer, std::span(best).subspan(at, std::min(blockSize, best.size() - at)));
    }
    bytes.piece(writer.take());
}

namespace {

quint64 takeRice(BitReader &reader, int k)
{
    const int high = reader.takeOnes(escapeOnes);
    return high == escapeOnes ? reader.take(64) : (static_cast<quint64>(high) << k) | reader.take(k);
}

quint64 takeResidual(BitReader &reader, int k, bool isFlagged)
{
    if (k == allZero || (isFlagged && reader.take(1) == 0)) {
        return 0;
    }
    return takeRice(reader, k) + (isFlagged ? 1 : 0);
}

bool takeModel(ArchiveCursor &cursor, Model &model)
{
    const quint64 predictor = cursor.number();
    model.predictor = static_cast<Predictor>(predictor);
    model.first = cursor.signedNumber();
    if (predictor == Straight) {
        model.slope = cursor.signedNumber();
    }
    return cursor.isGood() && predictor <= Straight;
}

} // namespace

std::vector<qint64> takeIntegers(ArchiveCursor &cursor, quint64 count)
{
    Model model;
    if (count == 0) {
        return {};
    }
    if (count > mostInColumn || !takeModel(cursor, model)) {
        cursor.fail();
        return {};
    }
    BitReader reader(cursor.piece());
    std::vector<qint64> values(static_cast<std::size_t>(count));
    qint64 before = 0;
    qint64 beforeThat = 0;
    int k = allZero;
    bool isFlagged = false;
    for (std::size_t i = 0; i < values.size() && reader.isGood(); ++i) {
        if (i % blockSize == 0) {
            const quint64 head = reader.take(7);
            k = static_cast<int>(head & 63);
            isFlagged = head & 64;
        }
        const qint64 residual = unzigzag(takeResidual(reader, k, isFlagged));
        values[i] = wrapped(bitsOf(model.predict(i, before, beforeThat)) + bitsOf(residual));
        beforeThat = before;
        before = values[i];
    }
    if (!reader.isGood() || !reader.isAtEnd()) {
        cursor.fail();
        return {};
    }
    return values;
}

} // namespace gorizont
