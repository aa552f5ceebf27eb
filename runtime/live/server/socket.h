#pragma once

#include <boost/asio/generic/stream_protocol.hpp>
#include <boost/beast/core/basic_stream.hpp>

namespace runtime {

// A connection that may be one of the Unix socket or of the loopback; its operations can be limited
// in time.
using Stream = boost::beast::basic_stream<boost::asio::generic::stream_protocol>;

}  // namespace runtime
