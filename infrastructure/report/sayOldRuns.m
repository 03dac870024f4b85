% SAYOLDRUNS  Says how many finished runs of the store count no longer, and why.
%
% CALL: sayOldRuns (CASE, RUNS, SAY)
%
%   CASE  see newCase
%   RUNS  see runsOfCase
%   SAY   function handle that takes one line of text
%
% The reason is that of the newest of them. Runs of a diagnosis belong to its
% effects and are left out.
%
% See also: sayCheck, calibrateCase, hashModels

function sayOldRuns (Case, runs, say)
  stages = cellfun (@(j) j.stage, {runs.job}, 'UniformOutput', false);
  isOld = ~[runs.isCurrent] & ~ismember (stages, {'gap', 'cure'}) & ...
          ismember ({runs.state}, {'ok', 'invalid', 'ended'});
  for k = 1:numel (Case.models)
    own = find (isOld & [runs.model] == k);
    if ~isempty (own)
      last = runs(own(end));
      say (sprintf (['old runs  %s: %d finished runs of the store do not ' ...
                     'count. The newest (%s): %s'], Case.models(k).name, ...
                    numel (own), last.folder, ...
                    whyOld (last, Case, Case.models(k))));
    end
  end
end

function text = whyOld (run, Case, model)
  head = checkReadText (fullfile (model.folder, 'data.head'));
  old = checkReadText (fullfile (run.folder, 'data.head'));
  cpu = str2double (checkReadText (fullfile (run.folder, 'cpu')));
  changed = otherFiles (model.folder, run.folder);
  if ~strncmp (old, head, numel (head))
    changed = [{'data.head'}, changed];
  end
  if numel (run.job.params) ~= numel (Case.names)
    text = sprintf ('it has %d parameters, the case has %d', ...
                    numel (run.job.params), numel (Case.names));
  elseif ~isempty (changed)
    text = sprintf ('the model has changed since: %s', ...
                    strjoin (changed, ', '));
  elseif ~isnan (cpu) && cpu ~= model.cpu
    text = sprintf ('it took %d CPUs, Input.cpu is %d', cpu, model.cpu);
  else
    text = otherVariables (run, Case);
  end
end

function names = otherFiles (model, run)
  aside = {'OctaveFuns', 'sample', '.git'};
  skip = cellfun (@(n) ['-path ./', n, ' -prune -o '], aside, ...
                  'UniformOutput', false);
  command = ['cd ', shellQuote(model), ' && find -L . ', skip{:}, ...
             '-type f ! -name data.head ! -name "README*" ', ...
             '! -name "picture.*" ! -name log.liggghts ', ...
             '-exec sh -c ''for f; do cmp -s "$f" "$0/$f" || echo "$f"; ', ...
             'done'' ', shellQuote(run), ' {} +'];
  [~, text] = system (command);
  names = regexp (text, '(?<=\./)[^\n]+', 'match');
end

function text = otherVariables (run, Case)
  job = run.job;
  if numel (job.effects) ~= numel (Case.effectVars)
    job.effects = neutralEffects (Case);
  end
  then = headDefaults (fullfile (run.folder, 'data.head'));
  now = runVariables (job, Case);
  text = 'it was made with another LIGGGHTS than the one that is found now';
  for name = fieldnames (now)'
    value = now.(name{1});
    if ~isfield (then, name{1}) || ...
       abs (then.(name{1}) - value) > 1e-12 * abs (value)
      text = sprintf ('its %s is not %g', name{1}, value);
    end
  end
end

%!function text = said (Case)
%!  text = evalc (['sayOldRuns (Case, runsOfCase (Case), ', ...
%!                 '@(t) printf (''%s\n'', t))']);
%!endfunction
%!test
%! Case = newCase (standInCase (tempname ()));
%! evaluateDEM ([1, 2; 3, 4], Case);
%! assert (said (Case), '');
%! other = Case;
%! other.modelVars.c = 3;
%! assert (~isempty (strfind (said (other), 'its c is not 3')));
%! other = Case;
%! other.models(1).cpu = 2;
%! text = said (other);
%! assert (~isempty (strfind (text, 'First: 2 finished')));
%! assert (~isempty (strfind (text, 'took 1 CPUs, Input.cpu is 2')));
%! assert (isempty (strfind (text, 'Second')));
%! script = fullfile (Case.models(1).folder, 'runscript');
%! writeAtomic (script, [fileread(script), "# liggghts\n"]);
%! assert (~isempty (strfind (said (Case), 'changed since: runscript')));
%! % another build
%! evaluateDEM ([1, 2; 3, 4], Case);
%! bin = tempname ();
%! mkdir (bin);
%! writeAtomic (fullfile (bin, 'liggghts'), 'a build');
%! system (['chmod +x ', fullfile(bin, 'liggghts')]);
%! before = getenv ('PATH');
%! setenv ('PATH', [bin, ':', before]);
%! text = said (Case);
%! setenv ('PATH', before);
%! assert (~isempty (strfind (text, '4 finished')));
%! assert (~isempty (strfind (text, 'another LIGGGHTS')));
