#pragma once

#include <QString>

#include <optional>
#include <utility>
#include <variant>

namespace gorizont {

/// Why an exchange or a driver's turn gave no value.
enum class Fault : quint8 {
    Timeout, ///< nothing, or not enough, arrived in time
    Checksum, ///< a frame arrived whole and its check sum is wrong
    BadReply, ///< a frame arrived with a good check sum and contents that make no sense
    Refused, ///< the device answered that it will not
    Closed, ///< the line is gone: unplugged, closed, connection lost
    Cancelled, ///< somebody asked for the wait to end
};

/// One word for logs, not for the operator.
QString faultName(Fault fault);

/// The line itself is gone or its thread is about to end: no device is at fault, and nothing else can be exchanged.
inline bool isLineFault(Fault fault)
{
    return fault == Fault::Closed || fault == Fault::Cancelled;
}

/// A value, or the reason why there is none.
template <typename T> class [[nodiscard]] Result
{
public:
    Result(T value)
        : m_content(std::in_place_index<0>, std::move(value))
    {
    }
    Result(Fault fault)
        : m_content(std::in_place_index<1>, fault)
    {
    }

    explicit operator bool() const { return m_content.index() == 0; }
    const T &operator*() const & { return std::get<0>(m_content); }
    T &operator*() & { return std::get<0>(m_content); }
    T &&operator*() && { return std::get<0>(std::move(m_content)); }
    const T *operator->() const { return &std::get<0>(m_content); }
    T *operator->() { return &std::get<0>(m_content); }
    Fault fault() const { return std::get<1>(m_content); }

private:
    std::variant<T, Fault> m_content;
};

template <> class [[nodiscard]] Result<void>
{
public:
    Result() = default;
    Result(Fault fault)
        : m_fault(fault)
    {
    }

    explicit operator bool() const { return !m_fault; }
    Fault fault() const { return *m_fault; }

private:
    std::optional<Fault> m_fault;
};

} // namespace gorizont
