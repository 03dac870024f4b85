% SDOFCHANGE  How well the change of one reading is known.
%
% CALL: [SD, FREEDOM, SEEN] = sdOfChange (BEFORE, NOW [, FURTHER])
%
%   BEFORE, NOW  structs with the fields sd, shared (1 x T), days (T x n) and the
%                freedoms of varianceComponents, of the reference and of the change
%   FURTHER      1 x T, variances that come to it and are known (0)
%   SD           of the difference (68 %); what both owe to the same sessions is no
%                part of it
%   FREEDOM      after Welch and Satterthwaite, 1 at least; the scatter of a trial
%                is one for both
%   SEEN         the smallest change that would show in 8 of 10 cases (5 %)

function [sd, freedom, seen] = sdOfChange (before, now, further)
  if nargin < 3
    further = 0;
  end
  own = max (before.sd.^2 - before.shared.^2, 0) + max (now.sd.^2 - now.shared.^2, 0);
  together = 0;
  if ~isempty (before.days)
    together = sum (before.days .* now.days, 2)';
  end
  sessions = max (before.shared.^2 + now.shared.^2 - 2 * together, 0);
  variance = own + sessions;
  least = @(name) min (before.(name), now.(name));
  doubt = variance.^2 ./ least ('freedom') + own.^2 ./ least ('commonFreedom') + ...
          sessions.^2 ./ least ('sessionFreedom');
  variance = variance + further;
  sd = sqrt (variance);
  freedom = max (variance.^2 ./ doubt, 1);
  freedom(~(doubt > 0)) = Inf;
  f = min (freedom, 1e6);            % quantiles of Student's distribution end there
  seen = sd .* (studentQuantile (0.975, f) + studentQuantile (0.8, f)) ./ ...
         -studentQuantile (0.1587, f);
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
%!test
%! % of known errors 1.96 + 0.84 of them; a part that is known doubts nothing
%! one = struct ('sd', 1, 'shared', 0, 'days', [], 'freedom', Inf, ...
%!               'commonFreedom', Inf, 'sessionFreedom', Inf);
%! [~, ~, seen] = sdOfChange (one, one);
%! assert (seen, sqrt (2) * (1.95996 + 0.84162), 1e-3);
%! one.freedom = 4;
%! [sd, freedom] = sdOfChange (one, one, 2);
%! assert ([sd, freedom], [2, 16], 1e-12);

% SPDX-License-Identifier: GPL-3.0-only
