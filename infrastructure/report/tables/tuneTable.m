% TUNETABLE  What runs cost with other values, and whether their results stay the same.
%
% CALL: LINES = tuneTable (NAMES, LIST, CASE)
%
%   NAMES  1 x n cellstr, what was tried
%   LIST   1 x n struct of decalioc tune: code, worst (number of a target), shift
%          (1 x T), runs, lost, cost (core-seconds), ratio (1 x 3: over today's, and
%          its interval)
%   CASE   see newCase
%   LINES  cell of texts, see tableText

function lines = tuneTable (names, list, Case)
  cells = cell (1, numel (list));
  info = targetInfo (Case);
  for k = 1:numel (list)
    one = list(k);
    worst = Case.targets(one.worst);
    unit = info(one.worst).unit;
    shift = quantity (one.shift(one.worst), unit);
    if one.shift(one.worst) >= 0
      shift = ['+', shift];
    end
    values = struct ('name', worst.name, 'runs', one.runs, 'lost', one.lost, ...
                     'shift', shift, 'half', ...
                     quantity (halfWidth (worst) / 2, unit));
    words = sentence (['tune.', one.code], values);
    if one.lost > 0 && ~strcmp (one.code, 'failed')
      words = [words, sentence('tune.lost', values)];
    end
    cells{k} = {names{k}, one.cost, one.ratio(1), one.ratio(2:3), words};
  end
  T = newTable (struct ('sources', struct ()), 'tune', ...
                'What a run costs, and whether its results stay the same', ...
                {'variable', '', ''; 'core-seconds a run', '', 'plain'; ...
                 'over today''s', '', 'plain'; '90 % interval', '', 'error'; ...
                 'results', '', 'words'}, cells, {sentence('table.tune')});
  lines = tableText (T);
end

% SPDX-License-Identifier: GPL-3.0-only
