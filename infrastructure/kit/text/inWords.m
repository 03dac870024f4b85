% INWORDS  A length of time as people say it.
%
% CALL: TEXT = inWords (SECONDS)

function text = inWords (seconds)
  if isnan (seconds)
    text = 'not known yet';
  elseif seconds < 90
    text = sprintf ('%.0f s', seconds);
  elseif seconds < 5400
    text = sprintf ('%.0f min', seconds / 60);
  elseif seconds < 172800
    text = sprintf ('%.1f h', seconds / 3600);
  else
    text = sprintf ('%.1f days', seconds / 86400);
  end
end

%!assert (inWords (12.3), '12 s')
%!assert (inWords (600), '10 min')
%!assert (inWords (9000), '2.5 h')
%!assert (inWords (NaN), 'not known yet')
%!assert (inWords (3 * 86400), '3.0 days')

% SPDX-License-Identifier: GPL-3.0-only
