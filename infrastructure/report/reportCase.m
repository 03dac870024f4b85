% REPORTCASE  Says which case is calibrated, and how.
%
% CALL: reportCase (CASE, SAY, PROBLEM)
%
%   CASE  see newCase
%   SAY   function handle that takes one line of text
%   PROBLEM  see newProblem: rows of costFunction beyond the targets

function reportCase (Case, say, problem)
  tell = @(varargin) say (sprintf (varargin{:}));
  tell ('DEcalioc  case %s', Case.folder);
  for m = Case.models
    tell ('  model %s (%s), %d CPU a run, %d targets', m.name, m.folder, ...
          m.cpu, m.nTargets);
  end
  [~, binary] = system ('command -v liggghts || echo none found');
  tell ('  LIGGGHTS: %s', strtrim (binary));
  o = Case.options;
  tell ('  %d parameters, %d targets, %d CPUs (%s), seed %d, method %s', ...
        numel (Case.names), numel (Case.targets), o.maxCPU, o.executor, ...
        o.seed, o.method);
  measured = measuredParams (Case);
  if ~isempty (measured)
    tell ('  measured parameters: %s', measured);
  end
  n = problem.nExtra;
  if n > 0 && strcmp (problem.options.method, 'published')
    tell ('  costFunction: %d rows beyond the targets, all are fitted', n);
  elseif n > 0
    tell (['  costFunction: %d rows beyond the targets are not fitted, as ' ...
           'they would'], n);
    say (['    pull the set off the targets: they choose among the sets ', ...
          'that meet them']);
  end
  cellfun (@(text) say (['  WARNING: ', text]), Case.notes);
  used = sum (strcmp ({Case.targets.role}, 'calibrate'));
  if used < numel (Case.names)
    tell (['  WARNING: %d targets cannot fix %d parameters: many sets will ' ...
           'meet them, and one is chosen'], used, numel (Case.names));
  end
  say ('');
end

%!test
%! Case = newCase (standInCase (tempname ()));
%! problem = newProblem (Case, @(p, f, Case) [f(p) ./ [400; 0.025; 3] - 1; 1]);
%! said = evalc ('reportCase (Case, @disp, problem)');
%! assert (! isempty (strfind (said, '1 rows beyond the targets are not')));
%! problem.options.method = 'published';
%! said = evalc ('reportCase (Case, @disp, problem)');
%! assert (! isempty (strfind (said, '1 rows beyond the targets, all are')));
