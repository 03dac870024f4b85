% SAYPLAN  Which test of the toolbox answers which question, before the first run.
%
% CALL: STATUS = sayPlan (ROOT, FOLDER, ARGS)
%
%   ROOT    folder of the toolbox (text);  FOLDER  not used
%   ARGS    cell of texts: none, or --for NAME (of an application in
%           share/regimes.csv), with --grain, --depth, --speed, --width of your
%           own in m and m/s
%   STATUS  0; 2 where no test lies near the application
%
% The tables are those of share/power.csv, which benchmarks/benchPower.m made
% from stored runs. With --for it says the stress and the inertial number of the
% application and of the tests, by order of magnitude:
%   P = bulk density g depth,  I = (speed / width) grain sqrt (density / P)
% (GDR MiDi 2004, doi 10.1140/epje/i2003-10153-0), and which tests lie within a
% factor of five in both; below I = 1e-3 flow does not depend on its speed.
%
% Errors: DEcalioc:sayPlan:badValue, :unknownName, those of commandOptions

function status = sayPlan (root, ~, args)
  sizes = {'grain', 'depth', 'speed', 'width'};
  spec = cell2struct (repmat ({'one'}, 5, 1), [{'for'}, sizes], 1);
  [options, words] = commandOptions (args, spec);
  given = ~cellfun (@isempty, struct2cell (rmfield (options, 'for'))');
  if ~isempty (words) || (isempty (options.for) && any (given))
    error ('DEcalioc:sayPlan:badValue', ...
           ['plan takes --for NAME and sizes of that application, got ''%s''. ' ...
            'decalioc plan --help shows the call.'], strjoin (args, ' '));
  end
  status = 0;
  regimes = numberRows (fullfile (root, 'share', 'regimes.csv'));
  if ~isempty (options.for)
    application = ofApplication (regimes, options, sizes(given));
    status = 2 * ~sayRegimes (application, ...
                              regimes(strcmp ({regimes.kind}, 'bench')));
  end
  sayPower (numberRows (fullfile (root, 'share', 'power.csv')));
end

% Rows of a table, numbers where they are.
function list = numberRows (file)
  list = tableRows (file);
  for name = fieldnames (list)'
    values = str2double ({list.(name{1})});
    if any (isfinite (values))
      [list.(name{1})] = num2cell (values){:};
    end
  end
end

function regime = ofApplication (regimes, options, given)
  list = regimes(strcmp ({regimes.kind}, 'application'));
  regime = list(strcmp ({list.name}, options.for));
  if isempty (regime)
    error ('DEcalioc:sayPlan:unknownName', ...
           '--for expects one of %s, got ''%s''.', ...
           strjoin ({list.name}, ', '), options.for);
  end
  for name = given
    units = {'m', 'm/s'};
    text = amountIn (options.(name{1}), units{1 + strcmp(name{1}, 'speed')});
    value = str2double (text);
    if ~(isfinite (value) && value > 0)
      error ('DEcalioc:sayPlan:badValue', ...
             '--%s must be a number above 0, in m or m/s, got ''%s''.', ...
             name{1}, options.(name{1}));
    end
    regime.(name{1}) = value;
  end
end

% Stress and inertial number, with 1500 kg/m3 of a grain and 60 % of the volume.
function [stress, inertial] = regimeOf (one)
  stress = 0.6 * 1500 * 9.81 * one.depth;
  inertial = one.speed / one.width * one.grain * sqrt (1500 / stress);
end

function isThere = sayRegimes (application, benches)
  [stress, inertial] = regimeOf (application);
  printf ('%s: %s\n', application.name, application.text);
  printf (['  grains of %g m, %g m deep, %g m/s over %g m (your own: --grain, ', ...
           '--depth, --speed, --width)\n'], application.grain, ...
          application.depth, application.speed, application.width);
  printf ('  stress about %.1g Pa, inertial number about %.1g\n\n', stress, ...
          inertial);
  isNear = false (1, numel (benches));
  for k = 1:numel (benches)
    [P, I] = regimeOf (benches(k));
    isNear(k) = abs (log (P / stress)) <= log (5) && ...
                abs (log (max (I, 1e-3) / max (inertial, 1e-3))) <= log (5);
    printf ('  %-9s stress about %.1g Pa, inertial number about %.1g%s\n', ...
            benches(k).name, P, I, repmat (': near', 1, isNear(k)));
  end
  isThere = any (isNear);
  if ~isThere
    printf (['\nWARNING: no test of the toolbox lies within a factor of five in ' ...
             'both. What it calibrates\nneed not hold there: measure on a rig ' ...
             'of that stress and speed, with a model of your own.\n']);
  end
  printf ("\n");
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
%! assert (isempty (strfind (out, 'inertial')));

%!test
%! % an application near a test, one far from all, and one made near by its sizes
%! [status, out] = said ('--for', 'hopper');
%! assert (status, 0);
%! assert (~isempty (regexp (out, 'Shear [^\n]*: near')));
%! [status, out] = said ('--for', 'storage');
%! assert (status, 2);
%! assert (~isempty (strfind (out, 'WARNING: no test')));
%! assert (said ('--for', 'storage', '--depth', '0.1', '--speed', '0.1', ...
%!               '--width', '0.03'), 0);

%!test
%! % a size with its unit
%! [~, out] = said ('--for', 'hopper', '--depth', '0.2', '--width', '0.05');
%! assert (nthargout (2, @said, '--for', 'hopper', '--depth', '20 cm', ...
%!                    '--width', '50mm'), out);
%!error <--depth must be a number above 0> said ('--for', 'drum', '--depth', '0,2')
%!error <expects one of hopper> said ('--for', 'moon')
%!error <--depth must be a number above 0> said ('--for', 'drum', '--depth', '-1')
%!error <plan takes --for NAME> said ('--depth', '1')
%!error <plan takes --for NAME> said ('hopper')
