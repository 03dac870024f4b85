% LOOROWS  Leave-one-out residuals of all targets, a run in each row.
%
% CALL: R = looRows (SURROGATES)
%
%   R           n x T, standardised; 0 x T where the surrogates stand on
%               different runs and cannot be laid side by side

function R = looRows (surrogates)
  lengths = arrayfun (@(s) numel (s.looStd), surrogates);
  R = zeros (0, numel (surrogates));
  if all (lengths == lengths(1))
    R = [surrogates.looStd];
  end
end

%!assert (looRows (struct ('looStd', {[1; 2], [3; 4]})), [1, 3; 2, 4])
%!assert (size (looRows (struct ('looStd', {[1; 2], 3}))), [0, 2])

% SPDX-License-Identifier: GPL-3.0-only
