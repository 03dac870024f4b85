% MEASUREDPARAMS  Lists the parameters that were measured by themselves.
%
% CALL: TEXT = measuredParams (CASE)
%
%   CASE  struct with names, paramMean and paramSd, see newCase
%   TEXT  'densityP 650 +- 5, ...'; '' where there are none

function text = measuredParams (Case)
  words = {};
  for j = find (isfinite (Case.paramMean) & isfinite (Case.paramSd))
    words{end + 1} = sprintf ('%s %g +- %g', Case.names{j}, ...
                              Case.paramMean(j), Case.paramSd(j));
  end
  text = strjoin (words, ', ');
end

%!test
%! Case = struct ('names', {{'a', 'b', 'c'}}, 'paramMean', [1, NaN, 3], ...
%!                'paramSd', [0.1, NaN, 2]);
%! assert (measuredParams (Case), 'a 1 +- 0.1, c 3 +- 2');
%! Case.paramMean(:) = NaN;
%! assert (measuredParams (Case), '');

% SPDX-License-Identifier: GPL-3.0-only
