% SDOFCHANGE  How well the change of one reading is known.
%
% CALL: [SD, FREEDOM] = sdOfChange (BEFORE, NOW)
%
%   BEFORE, NOW  structs with the fields sd, shared, days and the freedoms of
%                varianceComponents, of the reference and of the change
%   SD           of the difference (68 %); what both owe to the same sessions is no
%                part of it
%   FREEDOM      after Welch and Satterthwaite, 1 at least; the scatter of a trial
%                is one for both

function [sd, freedom] = sdOfChange (before, now)
  own = before.sd^2 - before.shared^2 + now.sd^2 - now.shared^2;
  together = 0;
  if ~isempty (before.days)
    together = before.days * now.days';
  end
  sessions = max (before.shared^2 + now.shared^2 - 2 * together, 0);
  sd = sqrt (own + sessions);
  least = @(name) min (before.(name), now.(name));
  doubt = sd^4 / least ('freedom') + own^2 / least ('commonFreedom') + ...
          sessions^2 / least ('sessionFreedom');
  freedom = max (sd^4 / doubt, 1);
end

%!test
%! one = struct ('sd', 5, 'shared', 4, 'days', [4, 0], 'freedom', 10, ...
%!               'commonFreedom', 20, 'sessionFreedom', 2);
%! other = setfield (one, 'days', [0, 4]);
%! [sd, freedom] = sdOfChange (one, other);
%! assert (sd, sqrt (50), 1e-12);
%! assert (freedom, 2500 / (2500 / 10 + 18^2 / 20 + 32^2 / 2), 1e-12);
%! % of the same days: the trials are left
%! [sd, freedom] = sdOfChange (one, one);
%! assert (sd, sqrt (18), 1e-12);
%! assert (freedom, 1 / (1 / 10 + 1 / 20), 1e-12);

% SPDX-License-Identifier: GPL-3.0-only
