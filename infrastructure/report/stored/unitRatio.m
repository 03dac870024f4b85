% UNITRATIO  Whether two values differ as two units do.
%
% CALL: TEXT = unitRatio (SIMULATED, MEASURED)
%
%   SIMULATED, MEASURED  scalars
%   TEXT                 '' or the factor and the units between which it lies:
%                        'about 1000, as between g and kg or mm and m'. Within a
%                        factor of 2.5 for powers of 1000, 1.25 for 60 and
%                        180 / pi, 1.05 for 9.81, up or down

function text = unitRatio (simulated, measured)
  known = {1e6, 2.5, '1e6, as between mg and kg or Pa and MPa'; ...
           1e9, 2.5, '1e9, as between mm3 and m3 or Pa and GPa'; ...
           1e3, 2.5, '1000, as between g and kg, mm and m or Pa and kPa'; ...
           58.6, 1.25, '60, as between s and min, rad and deg or 1/s and rpm'; ...
           9.81, 1.05, '9.81, as between kg and N'};
  text = '';
  ratio = simulated / measured;
  if ~isfinite (ratio) || ratio <= 0
    return
  end
  off = abs (abs (log (ratio)) - log ([known{:, 1}]));
  k = find (off <= log ([known{:, 2}]), 1);
  if ~isempty (k)
    text = ['a factor of about ', known{k, 3}];
  end
end

%!assert (unitRatio (0.0177, 17.3), ['a factor of about 1000, as between g ' ...
%!                                   'and kg, mm and m or Pa and kPa'])
%!assert (strncmp (unitRatio (26.5, 0.4625), 'a factor of about 60,', 21))
%!assert (strncmp (unitRatio (9.7, 1), 'a factor of about 9.81', 22))
%!test
%! for pair = {1, 1; 8, 1; 1, 0; 0, 1; -1000, 1; NaN, 1; 200, 1; 30, 1}'
%!   assert (unitRatio (pair{:}), '');
%! end

% SPDX-License-Identifier: GPL-3.0-only
