% OVERFRAMES  Mean of a reading over the frames of a run, and how well it is known.
%
% CALL: [VALUE, SD, EACH] = overFrames (FRAMES, READER)
%
%   FRAMES  1 x n cell, see readDump: of a state that stays the same (a turning drum)
%   READER  function handle, number = READER (GRAINS), such as
%           @(grains) surfaceLine (grains, -0.02, 0.02)
%   VALUE   mean of the n readings that are numbers
%   SD      standard uncertainty of VALUE: frames that follow each other are alike, so
%           n of them count as n (1 - r) / (1 + r), r the correlation of neighbours;
%           NaN for fewer than 3
%   EACH    1 x n, the readings
%
% See also: readDump, surfaceLine, silhouette

function [value, sd, each] = overFrames (frames, reader)
  each = cellfun (reader, frames(:)');
  known = each(isfinite (each));
  value = mean (known);
  sd = NaN;
  n = numel (known);
  if n == 0
    value = NaN;
  elseif n > 2
    rest = known - value;
    r = min (max (0, rest(1:end - 1) * rest(2:end)' / max (sumsq (rest), realmin)), ...
             0.99);
    sd = std (known) / sqrt (max (n * (1 - r) / (1 + r), 1));
  end
end

%!test
%! [value, sd, each] = overFrames ({1, 3, 2, NaN, 2}, @(g) 2 * g);
%! assert (value, 4);
%! assert (each, [2, 6, 4, NaN, 4]);
%! assert (sd, std ([2, 6, 4, 4]) / 2, 1e-9);
%!assert (isnan (overFrames ({}, @(g) 1)))
%!test
%! % frames that are alike count as few
%! [~, few] = overFrames (num2cell (repmat ([1, 2], 1, 20)), @(g) g);
%! [~, alike] = overFrames (num2cell ([ones(1, 20), 2 * ones(1, 20)]), @(g) g);
%! assert (alike > 3 * few);

% SPDX-License-Identifier: GPL-3.0-only
