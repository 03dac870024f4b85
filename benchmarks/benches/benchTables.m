% BENCHTABLES  Puts measured numbers of the benches into their documentation.
%
% CALL: benchTables (NSEEDS)
%
% NSEEDS  number of packings of effectSigns, for the text
%
% From benchmarks/results/benchNoise.csv: the tables of results in
% DEMmodels/<bench>/README.md and the table of benches in DEMmodels/README.md, where
% the line "Sees:" of that README tells what a bench sees; from
% effectSigns.csv: the signs in benchmarks/results/effectSigns.md; from
% benchChecks.csv: its table in DEMmodels/README.md. What stands between two marks
% "<!-- made by benchTables: NAME -->" is replaced.
%
% See also: effectSigns, benchChecks
function benchTables (nSeeds)
  root = startBenchmarks ();
  noise = words (root, 'benchNoise.csv');
  for bench = unique (noise(:, 1))'
    own = noise(strcmp (noise(:, 1), bench{1}), :);
    file = fullfile (root, 'DEMmodels', bench{1}, 'README.md');
    writeAtomic (file, benchText (fileread (file), own, nSeeds));
  end
  file = fullfile (root, 'DEMmodels', 'README.md');
  text = fileread (file);
  text = between (text, 'benches', noiseTable (root, noise));
  text = between (text, 'checks', ...
                  checksTable (words (root, 'benchChecks.csv')));
  writeAtomic (file, text);
  results = fullfile (root, 'benchmarks', 'results');
  file = fullfile (results, 'effectSigns.md');
  signs = effectTable (fullfile (results, 'effectSigns.csv'));
  writeAtomic (file, between (fileread (file), 'signs', signs));
end

function text = benchText (text, own, nSeeds)
  text = regexprep (text, '\d+ grains, [\d.]+ s of CPU\.', ...
                    sprintf ('%s grains, %s s of CPU.', own{1, 7:8}));
  text = regexprep (text, 'over \d+\npackings', ...
                    sprintf ("over %d\npackings", nSeeds));
  for k = 1:rows (own)
    line = ['(\| ', own{k, 2}, ' \| [^|]* \| [^|]* \|)[^\n]*'];
    text = regexprep (text, line, sprintf ('$1 %s | %s | %.2g %% |', ...
                                           own{k, [4, 5]}, ...
                                           100 * str2double (own{k, 6})));
  end
end

function text = noiseTable (root, noise)
  text = ["| bench | sees | grains | CPU seconds | noise of a run in its ", ...
          "results (relative) |\n|---|---|---|---|---|\n"];
  total = 0;
  for bench = unique (noise(:, 1))'
    own = noise(strcmp (noise(:, 1), bench{1}), :);
    share = @(name, r) sprintf ('%s %.2g %%', name, 100 * str2double (r));
    parts = cellfun (share, own(:, 2), own(:, 6), 'UniformOutput', false);
    text = [text, sprintf(['| [%s](%s/README.md) | %s | %s ', ...
                           "| %s | %s |\n"], bench{1}, bench{1}, ...
                          seenBy(root, bench{1}), own{1, 7:8}, ...
                          strjoin (parts', ', '))];
    total = total + str2double (own{1, 8});
  end
  text = [text, sprintf("\nAll %d together: %.0f s of one core.\n", ...
                        numel (unique (noise(:, 1))), total)];
end

% The line "Sees: ..." of the bench's README.
function text = seenBy (root, bench)
  file = fullfile (root, 'DEMmodels', bench, 'README.md');
  found = regexp (fileread (file), '^Sees: (.*?)\.?$', 'tokens', 'once', ...
                  'lineanchors', 'dotexceptnewline');
  text = [found{:}];
end

function text = checksTable (table)
  n = rows (table);
  off = table(strcmp (table(:, 8), 'no'), :);
  text = sprintf (['%d of %d results change by less than 2 standard ', ...
                   'deviations of one run. The others:\n\n| bench | check ', ...
                   '| result | before | after | standard deviations |\n', ...
                   '|---|---|---|---|---|---|\n'], n - rows (off), n);
  for k = 1:rows (off)
    text = [text, sprintf('| %s | %s | %s | %s | %s | %s |\n', ...
                          off{k, [1:5, 7]})];
  end
end

% A row an effect, a column a target: sign, and change in noise of a run; 0: not told
% from zero.
function text = effectTable (file)
  [~, words] = readCsvTable (file);
  text = '';
  for bench = unique (words(:, 3), 'stable').'
    own = words(strcmp (words(:, 3), bench{1}), :);
    targets = setdiff (unique (own(:, 4), 'stable'), {'none'}, 'stable');
    text = [text, sprintf("### %s\n\n| effect | strength |", bench{1}), ...
            sprintf(' %s |', targets{:}), sprintf("\n|---|---|"), ...
            repmat('---|', 1, numel (targets)), sprintf("\n")];
    for effect = unique (own(:, 1), 'stable').'
      text = [text, tableRow(own(strcmp (own(:, 1), effect{1}), :), targets)];
    end
    text = [text, sprintf("\n")];
  end
end

function text = tableRow (rows, targets)
  text = sprintf ('| %s | %s |', rows{1, 1}, rows{1, 2});
  for target = targets(:).'
    k = find (strcmp (rows(:, 4), target{1}), 1);
    if isempty (k)
      text = [text, ' failed |'];
    elseif strcmp (rows{k, 8}, '0')
      text = [text, ' 0 |'];
    else
      text = [text, sprintf(' %s %.1f |', rows{k, 8}, ...
                            abs (str2double (rows{k, 7})))];
    end
  end
  text = [text, sprintf("\n")];
end

function text = between (text, name, new)
  mark = sprintf ('<!-- made by benchTables: %s -->', name);
  at = strfind (text, mark);
  if numel (at) ~= 2
    error ('DEcalioc:benchTables:missingMark', ...
           'benchTables: the text must hold "%s" twice, got %d.', mark, ...
           numel (at));
  end
  text = [text(1:at(1) + numel(mark) - 1), "\n\n", strtrim(new), "\n\n", ...
          text(at(2):end)];
end

function table = words (root, name)
  [~, table] = readCsvTable (fullfile (root, 'benchmarks', 'results', name));
end

% SPDX-License-Identifier: GPL-3.0-only
