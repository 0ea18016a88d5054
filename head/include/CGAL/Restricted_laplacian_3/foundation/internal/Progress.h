// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_INTERNAL_PROGRESS_H
#define CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_INTERNAL_PROGRESS_H

#include <CGAL/Restricted_laplacian_3/foundation/exceptions.h>
#include <CGAL/Restricted_laplacian_3/foundation/internal/parameters.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <utility>

namespace CGAL {
namespace Restricted_laplacian_3 {
namespace internal {

/// Tells a user's callback which part of some work is done, from 0 to 1. A part of the work has a
/// progress of its own, from 0 to 1 again, so that who does it need not know what else there is.
/// What the callback hears never falls. Copies share that; calls are for one thread at a time.
class Progress {
public:
  /// what users give: takes the part that is done, and returns `false` to end the work
  using Callback = std::function<bool(double)>;

  /// nobody listens
  Progress() = default;
  /// \param progress may be empty
  explicit Progress(Callback callback) {
    if(callback)
      m_listener = std::make_shared<Listener>(Listener{std::move(callback), 0});
  }

  /// whether somebody listens
  bool is_shown() const { return m_listener != nullptr; }

  /// the progress of what is done between two parts of this work
  Progress part(double first, double last) const {
    Progress result = *this;
    result.m_first = m_first + m_length * first;
    result.m_length = m_length * (last - first);
    return result;
  }

  /// this as the callback of other work; empty if nobody listens
  Callback callback() const { return m_listener ? Callback(*this) : Callback(); }

  /// Tells that a part is done; anything outside of 0 to 1 counts as one of these.
  /// \return `true`, as a callback does
  /// \throws Canceled if `progress` returns `false`
  bool operator()(double done) const {
    if(!m_listener)
      return true;
    // a NaN is 0
    const double whole = m_first + m_length * (std::min)((std::max)(0., done), 1.);
    m_listener->heard = (std::max)(m_listener->heard, (std::min)(whole, 1.));
    if(!m_listener->callback(m_listener->heard))
      throw Canceled();
    return true;
  }

private:
  struct Listener {
    Callback callback;
    double heard;
  };

  std::shared_ptr<Listener> m_listener;
  double m_first = 0, m_length = 1;
};

/// the `callback` among named parameters, if it is there
template <class NamedParameters> Progress progress_of(const NamedParameters& np) {
  return Progress(parameters::choose_parameter(parameters::get_parameter(np, internal_np::progress),
                                               Progress::Callback()));
}

} // namespace internal
} // namespace Restricted_laplacian_3
} // namespace CGAL

#endif // CGAL_RESTRICTED_LAPLACIAN_3_FOUNDATION_INTERNAL_PROGRESS_H
