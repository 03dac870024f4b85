% SAYPLAN  Which test of the toolbox answers which question, before the first run.
%
% CALL: STATUS = sayPlan (ROOT, FOLDER, ARGS)
%
%   ROOT    folder of the toolbox (text);  FOLDER  not used
%   ARGS    empty cell
%   STATUS  0
%
% The tables are those of share/power.csv, which benchmarks/benchPower.m made
% from stored runs.
%
% Errors: DEcalioc:sayPlan:badValue

function status = sayPlan (root, ~, args)
  if ~isempty (args)
    error ('DEcalioc:sayPlan:badValue', ...
           'plan takes no words, got ''%s''. decalioc plan --help shows the call.', ...
           strjoin (args, ' '));
  end
  sayPower (numberRows (fullfile (root, 'share', 'power.csv')));
  status = 0;
end

% Rows of a table, numbers where they are.
function list = numberRows (file)
  [header, cells] = readCsvTable (file);
  list = cell2struct (cells, header, 2)';
  for name = fieldnames (list)'
    values = str2double ({list.(name{1})});
    if any (isfinite (values))
      [list.(name{1})] = num2cell (values){:};
    end
  end
end

function sayPower (table)
  isAlone = cellfun (@isempty, strfind ({table.benches}, '+'));
  alone = unique ({table(isAlone).benches});
  printf (['Which test fixes which parameter: the value is known to +- this ' ...
           'share of its range (45 %%: not at all)\n']);
  sayRows (table(strcmp ({table.kind}, 'parameter')), alone, ...
           @(row) sprintf ('%.0f %%', 100 * row.share));
  printf (['\nWhich test shows which cause: the least that is seen in 8 of 10 ' ...
           'cases, as a share of its range (-: not seen)\n']);
  sayRows (table(strcmp ({table.kind}, 'cause')), alone, @leastOf);
  printf (['\nBy all results of a test, of grains of 4 mm with the measurement ' ...
           'errors of examples/hiddenEffect and\nbenchmarks/drumAndBins ' ...
           '(benchmarks/benchPower.m). Empty: not studied, as the whole Doser.\n' ...
           'decalioc benches describes the tests; docs/effects.md the causes.\n']);
end

function text = leastOf (row)
  text = '-';
  if row.share <= 1
    text = sprintf ('%.0f %%', 100 * row.share);
  end
end

function sayRows (list, alone, show)
  printf ('  %-24s%s  best two\n', '', sprintf ('%10s', alone{:}));
  for name = unique ({list.name}, 'stable')
    regime = list(strcmp ({list.name}, name{1}));
    cells = repmat ({''}, 1, numel (alone));
    for k = 1:numel (alone)
      at = strcmp ({regime.benches}, alone{k});
      if any (at)
        cells{k} = show (regime(at));
      end
    end
    isPair = ~cellfun (@isempty, strfind ({regime.benches}, '+'));
    pairs = regime(isPair);
    [~, best] = min ([pairs.share]);
    pair = strtrim (sprintf ('%s %s', show (pairs(best)), ...
                             repmat (pairs(best).benches, 1, ...
                                     pairs(best).share <= 1)));
    printf ('  %-24s%s  %s\n', name{1}, sprintf ('%10s', cells{:}), pair);
  end
end

%!function [status, out] = said (varargin)
%!  root = fileparts (fileparts (which ('startToolbox')));
%!  [out, status] = evalc ('sayPlan (root, '''', varargin)');
%!endfunction

%!test
%! % the tables say what power.csv says
%! [status, out] = said ();
%! assert (status, 0);
%! assert (~isempty (regexp (out, 'densityP +\d+ %')));
%! assert (~isempty (regexp (out, 'cohesion +\d+ %')));
%! assert (~isempty (regexp (out, 'gain( +-)+\s')));

%!error <plan takes no words> said ('hopper')

% SPDX-License-Identifier: GPL-3.0-only
