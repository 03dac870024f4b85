% REPORTCASE  Says which case is calibrated, and how.
%
% CALL: reportCase (CASE, SAY)
%
%   CASE  see newCase
%   SAY   function handle that takes one line of text
%
% See also: DEcalioc

function reportCase (Case, say)
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
  cellfun (@(text) say (['  WARNING: ', text]), Case.notes);
  used = sum (strcmp ({Case.targets.role}, 'calibrate'));
  if used < numel (Case.names)
    say (sprintf (['  WARNING: %d targets cannot fix %d parameters: many ' ...
                   'sets will meet them, and one is chosen'], used, ...
                  numel (Case.names)));
  end
  say ('');
end
