% REPORTCASE  Says which case is calibrated, and how.
%
% CALL: reportCase (CASE, SAY, PROBLEM)
%
%   CASE  see newCase
%   SAY   function handle that takes one line of text
%   PROBLEM  see newProblem: rows of costFunction beyond the targets

function reportCase (Case, say, problem)
  say (sprintf ('DEcalioc  case %s', Case.folder));
  for k = 1:numel (Case.models)
    m = Case.models(k);
    say (sprintf ('  model %s (%s), %d CPU a run, %d targets', m.name, ...
                  m.folder, m.cpu, m.nTargets));
  end
  [~, binary] = system ('command -v liggghts');
  binary = strtrim (binary);
  if isempty (binary)
    binary = 'none found';
  end
  say (sprintf ('  LIGGGHTS: %s', binary));
  say (sprintf (['  %d parameters, %d targets, %d CPUs (%s), seed %d, ' ...
                 'method %s'], numel (Case.names), numel (Case.targets), ...
                Case.options.maxCPU, Case.options.executor, ...
                Case.options.seed, Case.options.method));
  measured = measuredParams (Case);
  if ~isempty (measured)
    say (sprintf ('  measured parameters: %s', measured));
  end
  sayFurtherRows (problem, say);
  cellfun (@(text) say (['  WARNING: ', text]), Case.notes);
  used = sum (strcmp ({Case.targets.role}, 'calibrate'));
  if used < numel (Case.names)
    say (sprintf (['  WARNING: %d targets cannot fix %d parameters: many ' ...
                   'sets will meet them, and one is chosen'], used, ...
                  numel (Case.names)));
  end
  say ('');
end

function sayFurtherRows (problem, say)
  n = problem.nExtra;
  if n > 0 && strcmp (problem.options.method, 'published')
    say (sprintf (['  costFunction: %d rows beyond the targets, all are ' ...
                   'fitted'], n));
  elseif n > 0
    say (sprintf (['  costFunction: %d rows beyond the targets are not ' ...
                   'fitted, as they would'], n));
    say (['    pull the set off the targets: they choose among the sets ', ...
          'that meet them']);
  end
end

%!function sayTo (file, text)
%!  fid = fopen (file, 'a');
%!  fprintf (fid, '%s\n', text);
%!  fclose (fid);
%!endfunction

%!test
%! file = tempname ();
%! Case = newCase (standInCase (tempname ()));
%! problem = newProblem (Case, @(p, f, Case) [f(p) ./ [400; 0.025; 3] - 1; 1]);
%! reportCase (Case, @(text) sayTo (file, text), problem);
%! problem.options.method = 'published';
%! reportCase (Case, @(text) sayTo (file, text), problem);
%! said = fileread (file);
%! delete (file);
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (Case.folder, 's');
%! assert (! isempty (strfind (said, '1 rows beyond the targets are not')));
%! assert (! isempty (strfind (said, '1 rows beyond the targets, all are')));
