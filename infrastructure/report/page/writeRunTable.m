% WRITERUNTABLE  Writes all runs of a case as a table: results/runTable.csv.
%
% CALL: writeRunTable (PAGE)
%
%   PAGE  see pageData
%
% One row a run: model, folder, stage, status, cause, replicate, seed, seconds,
% started (s since 1970), the design variables, the effect variables, the
% targets (empty where the run has no such result), message.
%
% See also: pageRuns, exportRuns

function writeRunTable (page)
  Case = page.Case;
  nEffects = numel (Case.effectVars);
  head = [{'model', 'folder', 'stage', 'status', 'cause', 'replicate', ...
           'seed', 'seconds', 'started'}, Case.names, Case.effectVars, ...
          {Case.targets.name}, {'message'}];
  lines = {strjoin(cellfun (@masked, head, 'UniformOutput', false), ',')};
  for run = page.runs
    effects = NaN (1, nEffects);
    n = numel (run.effects);
    if n == nEffects || n == numel (Case.coarse)
      effects(1:n) = run.effects;
    end
    numbers = [run.replicate, run.seed, run.seconds, run.started, ...
               run.params, effects, resultsOf(run, Case)];
    texts = arrayfun (@(x) sprintf ('%.17g', x), numbers, ...
                      'UniformOutput', false);
    texts(isnan (numbers)) = {''};
    words = cellfun (@masked, {run.model, run.name, run.stage, run.status, ...
                               run.cause}, 'UniformOutput', false);
    lines{end + 1} = strjoin ([words, texts, {masked(run.message)}], ',');
  end
  [~, ~] = mkdir (fullfile (Case.folder, 'results'));
  writeAtomic (fullfile (Case.folder, 'results', 'runTable.csv'), ...
               [strjoin(lines, "\n"), "\n"]);
end

function z = resultsOf (run, Case)
  z = NaN (1, numel (Case.targets));
  own = find (strcmp ({Case.targets.modelName}, run.model));
  for t = own
    index = Case.targets(t).index;
    if strcmp (run.status, 'ok') && numel (run.results) >= index
      z(t) = run.results(index);
    end
  end
end

function text = masked (text)
  text = text(:)';
  text(text < 32) = ' ';
  if any (ismember (text, ',;"'))
    text = ['"', strrep(text, '"', '""'), '"'];
  end
end

%!test
%! raw = standInCase (tempname ());
%! raw.optim.targetName = {{'sum (N)', 'product'}};
%! Case = newCase (raw);
%! evaluateDEM ([1, 2; 3, 4], Case);
%! writeRunTable (pageData (Case));
%! [head, cells] = readCsvTable (fullfile (Case.folder, 'results', ...
%!                                         'runTable.csv'));
%! assert (rows (cells), 4);
%! first = find (strcmp (cells(:, 1), 'First'));
%! sums = str2double (cells(first, strcmp (head, 'sum (N)')));
%! assert (sort (sums), [3; 7], 1e-12);
%! second = find (strcmp (cells(:, 1), 'Second'));
%! assert (all (cellfun (@isempty, cells(second, strcmp (head, 'product')))));
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (Case.folder, 's');
