% TWINSFREEZE  Writes truth, its digest and the observables before any scoring.
%
% CALL: DIGEST = twinsFreeze (NAME, TWINS, LABS)
%
%   NAME    path without ending; NAME-truth.csv, NAME-truth.sha256 and
%           NAME-cases.csv are written
%   TWINS   of twinsDraw;  LABS  of twinsLaboratories
%   DIGEST  text, SHA-256 of the truth file
%
% See also: twins

function digest = twinsFreeze (name, twins, labs)
  id = fopen ([name, '-truth.csv'], 'w');
  fprintf (id, 'case,lab,class,cause,removed,d,theta,phi\n');
  for i = 1:numel (twins)
    t = twins(i);
    fprintf (id, '%d,%s,%s,%s,%d,%.6g,%s,%s\n', i, labs(t.lab).name, ...
             t.class, strtrim (sprintf ('%d ', t.cause)), t.removed, t.d, ...
             strtrim (sprintf ('%.6g ', t.theta)), ...
             strtrim (sprintf ('%.6g ', t.phi)));
  end
  fclose (id);
  digest = hash ('sha256', fileread ([name, '-truth.csv']));
  id = fopen ([name, '-truth.sha256'], 'w');
  [~, stem] = fileparts (name);
  fprintf (id, '%s  %s-truth.csv\n', digest, stem);
  fclose (id);
  id = fopen ([name, '-cases.csv'], 'w');
  fprintf (id, 'case,lab,removed,y\n');
  for i = 1:numel (twins)
    t = twins(i);
    fprintf (id, '%d,%s,%d,%s\n', i, labs(t.lab).name, t.removed, ...
             strtrim (sprintf ('%.10g ', t.y)));
  end
  fclose (id);
end
