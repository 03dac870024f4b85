% SAYTUNE  Looks for cheaper runs that give the same results.
%
% CALL: STATUS = sayTune (ROOT, FOLDER, ARGS)
%
%   ROOT    folder of the toolbox (text);  FOLDER  case folder (text)
%   ARGS    cell of texts: --vary NAME=V,V,... for each variable of data.head that
%           is to be tried (cpu: the CPUs of a run), --repeats N (default 4)
%   STATUS  0; 2 where nothing cheaper gives the same results
%
% Each value is run N times alone, the other variables as they are, with the
% parameters in the middle of the limits. See compareVariants for what counts as the
% same. The runs lie in FOLDER/tune and are used again. Seconds are those of the
% clock: on a busy machine the cost is that of a busy machine.
%
% Errors: DEcalioc:sayTune:badValue, :unknownName, those of commandOptions

function status = sayTune (root, folder, args)
  options = commandOptions (args, struct ('vary', 'many', 'repeats', 'one'));
  repeats = str2double ([options.repeats, repmat('4', 1, isempty (options.repeats))]);
  if ~(repeats >= 2 && repeats == round (repeats)) || isempty (options.vary)
    error ('DEcalioc:sayTune:badValue', ...
           ['tune takes --vary NAME=VALUE,VALUE once or more, and --repeats with a ' ...
            'whole number from 2 on, got ''%s''. decalioc tune --help shows the call.'], ...
           strjoin (args, ' '));
  end
  useLiggghts (root);
  Case = loadCase (root, folder);
  variants = [struct('name', 'as it is', 'variable', '', 'value', NaN), ...
              eachOf(@(word) variantsOf (word, Case), options.vary){:}];
  lock = lockCase (folder);
  Case.store = fullfile (folder, 'tune');
  Case.options.maxNewRuns = Inf;
  [~, ~] = mkdir (Case.store);
  p = toAllowed (boxCentre (Case.limits), Case);
  n = [numel(variants), repeats, numel(Case.models)];
  printf ('%s x %s x %s = %s\n', countText (n(1), 'value'), countText (n(2), 'repeat'), ...
          countText (n(3), 'model'), countText (prod (n), 'run'));
  [Z, S] = deal (cell (1, numel (variants)));
  for k = 1:numel (variants)
    [Z{k}, S{k}] = runVariant (variants(k), Case, p, repeats);
  end
  allowed = arrayfun (@halfWidth, Case.targets);
  list = compareVariants (Z, S, allowed);
  cellfun (@(line) printf ('%s\n', line), tableText (tableOf (variants, list, Case)));
  status = 2 * ~sayBest (variants, list);
end

% 'percentRayleigh=0.2,0.3' as one variant a value.
function list = variantsOf (word, Case)
  [name, values] = strtok (word, '=');
  values = str2double (strsplit (values(2:end), ','));
  if ~all (isfinite (values)) || isempty (name)
    error ('DEcalioc:sayTune:badValue', ...
           '--vary expects NAME=VALUE,VALUE with numbers, got ''%s''.', word);
  end
  known = {'cpu'};
  for model = Case.models
    file = fullfile (model.folder, 'data.head');
    if isfile (file)
      known = [known, fieldnames(headDefaults (file))'];
    end
  end
  if ~any (strcmp (name, known)) || any (strcmp (name, Case.names))
    error ('DEcalioc:sayTune:unknownName', ...
           ['--vary expects cpu or a variable of a data.head that is no parameter ' ...
            'of the case, got ''%s''. %s'], name, checkNearest (name, known));
  end
  list = struct ('name', eachOf (@(v) sprintf ('%s=%g', name, v), values), ...
                 'variable', name, 'value', num2cell (values));
end

function [Z, S] = runVariant (variant, Case, p, repeats)
  if strcmp (variant.variable, 'cpu')
    [Case.models.cpu] = deal (variant.value);
  elseif ~isempty (variant.variable)
    Case.modelVars.(variant.variable) = variant.value;
  end
  say = @(text) printf ('%s\n', text);
  [Z, records] = evaluateDEM (repmat (p, repeats, 1), Case, (1:repeats)', 'tune', ...
                              newProgress (variant.name, say));
  S = reshape ([records.seconds], size (records)) * [Case.models.cpu]';
end

function T = tableOf (variants, list, Case)
  cells = cell (1, numel (list));
  for k = 1:numel (list)
    one = list(k);
    worst = Case.targets(one.worst);
    shift = one.shift(one.worst);
    codes = {one.code, 'near'};          % more repeats than anybody makes
    values = struct ('name', worst.name, 'runs', one.runs, ...
                     'shift', plainNumber (shift, 'change'), ...
                     'half', plainNumber (halfWidth (worst) / 2, 'plain'));
    cells{k} = {variants(k).name, one.cost, one.ratio(1), one.ratio(2:3), ...
                sentence(['tune.', codes{1 + (one.runs > 200)}], values)};
  end
  T = newTable (struct ('sources', struct ()), 'tune', ...
                'What a run costs, and whether its results stay the same', ...
                {'variable', '', ''; 'core-seconds a run', '', 'plain'; ...
                 'over today''s', '', 'plain'; '90 % interval', '', 'error'; ...
                 'results', '', 'words'}, cells, {sentence('table.tune')});
end

function isFound = sayBest (variants, list)
  isGood = strcmp ({list.code}, 'same') & arrayfun (@(v) v.ratio(3) < 1, list);
  isFound = any (isGood);
  if ~isFound
    printf ('%s\n', sentence ('tune.none'));
    return
  end
  k = find (isGood);
  [~, best] = min (arrayfun (@(v) v.ratio(1), list(k)));
  v = variants(k(best));
  places = {sprintf('modelVars.%s = %g;', v.variable, v.value), ...
            sprintf('Input.cpu = %g;', v.value)};
  printf ('%s\n', sentence ('tune.best', ...
                            struct ('line', places{1 + strcmp(v.variable, 'cpu')}, ...
                                    'share', plainNumber (list(k(best)).ratio(1), 'percent'))));
end

%!function [text, status] = tuned (varargin)
%!  % a model whose runs get cheaper with e, and shift by it
%!  raw = standInCase (tempname ());
%!  writeLoadInput (raw.folder);
%!  for name = {'First', 'Second'}
%!    file = fullfile (raw.folder, 'DEMmodels', name{1}, 'runscript');
%!    writeAtomic (file, ["sleep $(awk '$2 == \"slow\" { s = $4 } END { print s }' ", ...
%!                        "data.head)\n", fileread(file)]);
%!    head = fullfile (raw.folder, 'DEMmodels', name{1}, 'data.head');
%!    writeAtomic (head, ["variable slow equal 0.6\n", fileread(head)]);
%!  end
%!  [status, text] = startCommand (raw.folder, ['tune ', strjoin(varargin, ' ')]);
%!endfunction
%!test
%! % how much cheaper, the clock says, which on a busy machine is no test
%! [text, status] = tuned ('--vary slow=0.01 --vary e=9 --repeats 2');
%! assert (any (status == [0, 2]), text);
%! assert (~isempty (strfind (text, '3 values x 2 repeats x 2 models = 12 runs')), text);
%! assert (~isempty (regexp (text, 'slow=0.01 [^\n]*the same')), text);
%! assert (~isempty (regexp (text, 'e=9 .*shifts by \+9')), text);
%!test
%! for words = {'--vary slo=1', 'Did you mean slow?'; '--vary a=1', 'no parameter'; ...
%!              '--vary slow=x', 'with numbers'; '', 'once or more'; ...
%!              '--vary slow=1 --repeats 1', 'from 2 on'}'
%!   [text, status] = tuned (words{1});
%!   assert (status, 1);
%!   assert (~isempty (strfind (text, words{2})), text);
%! end
