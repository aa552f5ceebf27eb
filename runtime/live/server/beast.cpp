// All of Boost.Asio and Boost.Beast that is no template.
#include <boost/asio/impl/src.hpp>
#include <boost/beast/src.hpp>
