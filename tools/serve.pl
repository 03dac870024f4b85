#!/usr/bin/perl
# Shows the report of a case in a browser of this machine, and follows a run.
#
# CALL: serve.pl DECALIOC CASE PORT
#
#   DECALIOC  the command, which writes the page anew when a browser asks and
#             the last one is older than 15 seconds
#   CASE      folder of the case;  PORT  0: one that is free
#
# It listens on the loopback interface only, answers one page and no other file,
# and only where the browser was told 127.0.0.1 or localhost: a page of somebody
# else could not read it by a name of its own. Ctrl-C ends it.
use strict;
use warnings;
use IO::Socket::INET;

my ($decalioc, $case, $port) = @ARGV;
my $page = "$case/results/report.html";
my $server = IO::Socket::INET->new (LocalAddr => '127.0.0.1', LocalPort => $port,
                                    Listen => 5, ReuseAddr => 1)
  or die "decalioc: port $port of 127.0.0.1 cannot be had: $!. "
       . "Name another one: --serve=8700, or --serve=0 for one that is free.\n";
$port = $server->sockport;
$SIG{INT} = $SIG{TERM} = sub { print "\n"; exit 0 };
$SIG{PIPE} = 'IGNORE';
$| = 1;
print "http://127.0.0.1:$port/   (Ctrl-C ends it)\n";
my $made = 0;
while (1) {
  my $client = $server->accept or next;
  eval { answer ($client) };
  close $client;
}

sub answer {
  my ($client) = @_;
  # a browser that opens a line and says nothing must not stop the others
  local $SIG{ALRM} = sub { die "silent\n" };
  alarm 5;
  my $first = <$client> // '';
  my $host = '';
  while (defined (my $line = <$client>)) {
    last if $line =~ /^\r?\n$/;
    $host = lc $1 if $line =~ /^Host:\s*([^\s:]+)/i;
  }
  alarm 0;
  return send_to ($client, '403 Forbidden', 'Ask for http://127.0.0.1:' . $port)
    unless $host eq '127.0.0.1' || $host eq 'localhost';
  return send_to ($client, '404 Not Found', 'There is one page only: /')
    unless $first =~ m{^GET /(\?\S*)? HTTP/};
  my $text = fresh ();
  return send_to ($client, '503 Service Unavailable',
                  'There is no report yet: the page comes by itself.')
    unless defined $text;
  send_to ($client, '200 OK', $text);
}

sub fresh {
  if (time - $made > 15) {
    # what it says would fill the terminal
    system ('sh', '-c', '"$0" report "$1" > /dev/null 2>&1', $decalioc, $case);
    $made = time;
  }
  open (my $in, '<:raw', $page) or return undef;
  local $/;
  return scalar <$in>;
}

sub send_to {
  my ($client, $status, $text) = @_;
  print $client "HTTP/1.1 $status\r\nContent-Type: text/html; charset=utf-8\r\n"
              . "Content-Length: " . length ($text) . "\r\nRefresh: 20\r\n"
              . "Cache-Control: no-store\r\nX-Frame-Options: DENY\r\n"
              . "Connection: close\r\n\r\n$text";
}
