% SHIFTSERIES  Reads curves that results lie on at shifted places.
%
% CALL: Z = shiftSeries (Z, SHIFT, INFO, PREFIX)
%
% Z       n x T results
% SHIFT   shift along the curve, in the unit of INFO.at
% INFO    1 x T struct array of resultInfo
% PREFIX  curves whose series begins with this word are shifted
%
% Each result moves by SHIFT times the slope of its curve: a central
% difference inside, a one-sided one at the ends. So Z stays affine in itself
% and linear in SHIFT. A curve of one point does not move.
%
% See also: effectTimeOffset, effectSpeedError
function Z = shiftSeries (Z, shift, info, prefix)
  series = {info.series};
  for name = unique (series(strncmp (series, prefix, numel (prefix))))
    members = find (strcmp (series, name{1}));
    [at, order] = sort ([info(members).at]);
    members = members(order);
    m = numel (members);
    if m > 1
      before = max ((1:m) - 1, 1);
      after = min ((1:m) + 1, m);
      values = Z(:, members);
      slope = (values(:, after) - values(:, before)) ./ ...
              (at(after) - at(before));
      Z(:, members) = values + shift * slope;
    end
  end
end

%!test % a straight line moves by shift x slope, another curve stays
%! info = struct ('series', {'time', 'time', 'x', 'time'}, 'at', {2, 1, 1, 4});
%! z = shiftSeries ([7, 4, 1, 13], 0.5, info, 'time');
%! assert (z, [8.5, 5.5, 1, 14.5], 1e-12);

% SPDX-License-Identifier: GPL-3.0-only
